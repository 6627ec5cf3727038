import { joints } from '../../effects/effect/chunks.js';
import { motorFields } from './motor-fields.js';
import { defineNode } from '../node/define.js';
import type { MotorJointNode } from './motor-joint-node.js';

export const motorJoint = defineNode<MotorJointNode>({
  name: 'MotorJoint',
  containerField: 'joints',
  clause: '37.4.10',
  doc: 'Turns two bodies against each other by torques about up to three axes.',
  rank: 3,
  chunk: joints,
  fields: motorFields,
});
