import { joints } from '../../effects/effect/chunks.js';
import { anchorFields, axisField, jointFields, output } from './joint-fields.js';
import { angleStop, bounceField, correctionField } from './stop-fields.js';
import { defineNode } from '../node/define.js';
import type { SingleAxisHingeJointNode } from './single-axis-hinge-joint-node.js';

const stops = (joint: SingleAxisHingeJointNode): void => joint.updateRows();

export const singleAxisHingeJoint = defineNode<SingleAxisHingeJointNode>({
  name: 'SingleAxisHingeJoint',
  containerField: 'joints',
  clause: '37.4.14',
  doc: 'Lets two bodies turn about one axis.',
  rank: 3,
  chunk: joints,
  fields: {
    ...jointFields,
    ...anchorFields,
    axis: axisField([0, 1, 0], {
      doc: 'Direction of the axis, world frame, when the joint is made. Editing it makes the joint anew.',
    }),
    minAngle: angleStop(-Math.PI, stops, {
      doc: 'Lower stop, radians from the pose the joint was made at. Above maxAngle: no stops.',
    }),
    maxAngle: angleStop(Math.PI, stops, { doc: 'Upper stop, radians.' }),
    stopBounce: bounceField(stops, {
      doc: 'Share of the turning speed that comes back from a stop.',
    }),
    stopErrorCorrection: correctionField(0.8, stops, {
      doc: 'Share of an overshoot past a stop repaired per 1/60 s.',
    }),
    angle: output(
      (joint) => joint.angle,
      { doc: 'Angle of body1 relative to body2, radians in (-π, π].' },
      {
        angle: 1,
      },
    ),
    angleRate: output((joint) => joint.angleRate, { doc: 'Its rate, rad/s.' }, { angle: 1 }),
  },
});
