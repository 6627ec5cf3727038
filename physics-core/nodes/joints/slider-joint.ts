import { joints } from '../../effects/effect/chunks.js';
import { jointFields, output } from './joint-fields.js';
import { bounceField, correctionField } from './stop-fields.js';
import { defineNode } from '../node/define.js';
import type { Doc, Field } from '../node/table.js';
import type { SliderJointNode } from './slider-joint-node.js';

const stops = (joint: SliderJointNode): void => joint.updateRows();
const force = (joint: SliderJointNode): void => joint.updateMotors();

const separation = (value: number, { doc }: Doc): Field<SliderJointNode> => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: value,
  dimension: { length: 1 },
  edit: 'live',
  patch: stops,
  doc,
});

export const sliderJoint = defineNode<SliderJointNode>({
  name: 'SliderJoint',
  containerField: 'joints',
  clause: '37.4.15',
  doc: 'Lets two bodies slide along one axis; neither turns against the other.',
  rank: 3,
  chunk: joints,
  fields: {
    ...jointFields,
    axis: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 1, 0],
      edit: 'rebuild',
      doc: 'Direction in which they slide, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew.',
    },
    minSeparation: separation(0, {
      doc: 'Lower stop, metres from the pose the joint was made at; negative is allowed. Above maxSeparation: no stops.',
    }),
    maxSeparation: separation(1, { doc: 'Upper stop, metres.' }),
    sliderForce: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      dimension: { force: 1 },
      edit: 'live',
      patch: force,
      doc: 'Newtons along the axis on both bodies in every step: positive pushes them apart, negative pulls them together.',
    },
    stopBounce: bounceField(stops, { doc: 'Share of the speed that comes back from a stop.' }),
    stopErrorCorrection: correctionField(1, stops, {
      doc: 'Share of an overshoot past a stop repaired per 1/60 s.',
    }),
    separation: output(
      (joint) => joint.separation,
      {
        doc: 'Metres that the bodies moved apart since the joint was made; where neither lay ahead of the other, metres that body1 moved along the axis.',
      },
      { length: 1 },
    ),
    separationRate: output(
      (joint) => joint.separationRate,
      { doc: 'Its rate, m/s.' },
      { length: 1 },
    ),
  },
});
