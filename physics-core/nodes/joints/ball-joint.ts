import { joints } from '../../effects/effect/chunks.js';
import { anchorFields, jointFields } from './joint-fields.js';
import { defineNode } from '../node/define.js';
import type { BallJointNode } from './ball-joint-node.js';

export const ballJoint = defineNode<BallJointNode>({
  name: 'BallJoint',
  containerField: 'joints',
  clause: '37.4.1',
  doc: 'Holds a point of both bodies together and lets them turn about it.',
  rank: 3,
  chunk: joints,
  fields: { ...jointFields, ...anchorFields },
});
