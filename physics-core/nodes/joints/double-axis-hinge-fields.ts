import type { DoubleAxisHingeJointNode } from './double-axis-hinge-joint-node.js';
import { anchorFields, axisField, axisOutput, jointFields, output } from './joint-fields.js';
import { angleStop, bounceField, correctionField } from './stop-fields.js';
import type { Field } from '../node/table.js';

const stops = (joint: DoubleAxisHingeJointNode): void => joint.updateRows();
const motors = (joint: DoubleAxisHingeJointNode): void => joint.updateMotors();
const suspension = (joint: DoubleAxisHingeJointNode): void => joint.updateRows();

type HingeField = Field<DoubleAxisHingeJointNode>;

const motorFields = (n: 1 | 2): Record<string, HingeField> => ({
  [`desiredAngularVelocity${n}`]: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0,
    dimension: { angle: 1 },
    edit: 'live',
    patch: motors,
    doc: `Rate that the motor about axis ${n} strives for, rad/s, body1 relative to body2.`,
  },
  [`maxTorque${n}`]: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0,
    range: [0, Infinity],
    dimension: { force: 1, length: 1 },
    edit: 'live',
    patch: motors,
    doc: `Torque that the motor about axis ${n} can muster, newton metres; 0: no motor.`,
  },
});

/** Names before X3D 4.0 had the number of the axis at their end. */
const named3 = (field: HingeField, alias: string): HingeField => ({ ...field, aliases: [alias] });

const stopFields: Record<string, HingeField> = {
  minAngle1: angleStop(-Math.PI, stops, {
    doc: 'Lower stop of the angle about axis 1, radians from the pose the joint was made at. Above maxAngle1: no stops. Equal to it: held there.',
  }),
  maxAngle1: angleStop(Math.PI, stops, { doc: 'Upper stop of the angle about axis 1, radians.' }),
  stop1Bounce: named3(
    bounceField(stops, { doc: 'Share of the rate about axis 1 that comes back from a stop.' }),
    'stopBounce1',
  ),
  stop1ErrorCorrection: named3(
    correctionField(0.8, stops, { doc: 'Share of an overshoot past a stop repaired per 1/60 s.' }),
    'stopErrorCorrection1',
  ),
  stop1ConstantForceMix: named3(
    {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.001,
      range: [0, Infinity],
      edit: 'live',
      patch: stops,
      doc: 'How far the stops give way: a steady torque sinks in by constantForceMix / (60 · errorCorrection) radians per newton metre. 0: not at all.',
    },
    'stopConstantForceMix1',
  ),
};

const suspensionFields: Record<string, HingeField> = {
  suspensionForce: {
    type: 'SFFloat',
    access: 'inputOutput',
    default: 0,
    range: [0, Infinity],
    edit: 'live',
    patch: suspension,
    doc: 'Softness of the suspension along axis 1, despite its name: stiffness 60 · suspensionErrorCorrection / suspensionForce N/m, damping (1 - suspensionErrorCorrection) / suspensionForce N s/m. 0: rigid.',
  },
  suspensionErrorCorrection: correctionField(0.8, suspension, {
    doc: 'Share of the spring against the damper in the suspension: 1 has no damper, 0 no spring.',
  }),
};

const angle = { angle: 1 };

const outputs: Record<string, HingeField> = {
  hinge1Angle: output(
    (joint) => joint.hingeAngle(1),
    { doc: 'Angle about axis 1 of body1 relative to body2, radians in (-π, π].' },
    angle,
  ),
  hinge1AngleRate: output((joint) => joint.hingeAngleRate(1), { doc: 'Its rate, rad/s.' }, angle),
  hinge2Angle: output(
    (joint) => joint.hingeAngle(2),
    { doc: 'Angle about axis 2 of body1 relative to body2, radians in (-π, π].' },
    angle,
  ),
  hinge2AngleRate: output((joint) => joint.hingeAngleRate(2), { doc: 'Its rate, rad/s.' }, angle),
};

export const doubleAxisHingeFields: Record<string, HingeField> = {
  ...jointFields,
  ...anchorFields,
  axis1: axisField([1, 0, 0], {
    doc: 'Axis of steering and suspension, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew.',
  }),
  axis2: axisField([0, 1, 0], {
    doc: 'Axis of spin, world frame, when the joint is made; body2 carries it. The angle between the axes stays as it is then.',
  }),
  ...stopFields,
  ...motorFields(1),
  ...motorFields(2),
  ...suspensionFields,
  ...outputs,
  body1Axis: axisOutput(1, 2),
  body2Axis: axisOutput(2, 0),
};
