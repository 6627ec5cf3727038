import { joints } from '../../effects/effect/chunks.js';
import { anchorFields, axisField, axisOutput, jointFields } from './joint-fields.js';
import { idleStop } from './stop-fields.js';
import { defineNode } from '../node/define.js';
import type { UniversalJointNode } from './universal-joint-node.js';

export const universalJoint = defineNode<UniversalJointNode>({
  name: 'UniversalJoint',
  containerField: 'joints',
  clause: '37.4.16',
  doc: 'A cardan joint: turns one body with the other round a bend.',
  rank: 3,
  chunk: joints,
  fields: {
    ...jointFields,
    ...anchorFields,
    axis1: axisField([1, 0, 0], {
      doc: 'First arm of the cross, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew.',
    }),
    axis2: axisField([0, 1, 0], {
      doc: 'Second arm, at right angles to the first, world frame, when the joint is made; body2 carries it. Editing it makes the joint anew.',
    }),
    stop1Bounce: idleStop(1, 'Bounce'),
    stop1ErrorCorrection: idleStop(1, 'ErrorCorrection'),
    stop2Bounce: idleStop(2, 'Bounce'),
    stop2ErrorCorrection: idleStop(2, 'ErrorCorrection'),
    body1Axis: axisOutput(1, 2),
    body2Axis: axisOutput(2, 0),
  },
});
