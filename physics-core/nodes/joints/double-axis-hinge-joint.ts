import { joints } from '../../effects/effect/chunks.js';
import { doubleAxisHingeFields } from './double-axis-hinge-fields.js';
import { defineNode } from '../node/define.js';
import type { DoubleAxisHingeJointNode } from './double-axis-hinge-joint-node.js';

export const doubleAxisHingeJoint = defineNode<DoubleAxisHingeJointNode>({
  name: 'DoubleAxisHingeJoint',
  containerField: 'joints',
  clause: '37.4.9',
  doc: 'The wheel of a car: steering and suspension about and along one axis, spin about another.',
  rank: 3,
  chunk: joints,
  fields: doubleAxisHingeFields,
});
