import type { Vec3 } from '../../fields/types.js';
import { axisField, jointFields, output } from './joint-fields.js';
import type { AxisNumber, MotorJointNode } from './motor-joint-node.js';
import { idleStop } from './stop-fields.js';
import type { Field } from '../node/table.js';

type MotorField = Field<MotorJointNode>;

const idle = (joint: MotorJointNode): void => joint.reportIdle();
const torque = (joint: MotorJointNode): void => {
  joint.updateMotors();
  joint.reportIdle();
};

const axisOf = (n: AxisNumber, value: Vec3): MotorField =>
  axisField(value, {
    doc: `Direction of axis ${n}, world frame when the joint is made. It turns with body1; with autoCalc axis 3 turns with body2 and axis 2 is axis 3 × axis 1. Without a direction it turns nothing. Editing it makes the joint anew.`,
  });

const angleOf = (n: AxisNumber): MotorField => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: 0,
  range: [-Math.PI, Math.PI],
  dimension: { angle: 1 },
  edit: 'passive',
  patch: idle,
  doc: `Angle about axis ${n} as the author measured it, radians: motor${n}Angle says it again, unless autoCalc measures it. It drives nothing.`,
});

const torqueOf = (n: AxisNumber): MotorField => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: 0,
  dimension: { force: 1, length: 1 },
  edit: 'live',
  patch: torque,
  doc: `Torque about axis ${n}, newton metres: plus on body1, minus on body2.`,
});

/** All that an axis has. */
const fieldsOf = (n: AxisNumber, axis: Vec3): Record<string, MotorField> => ({
  [`motor${n}Axis`]: axisOf(n, axis),
  [`axis${n}Angle`]: angleOf(n),
  [`axis${n}Torque`]: torqueOf(n),
  [`stop${n}Bounce`]: idleStop(n, 'Bounce'),
  [`stop${n}ErrorCorrection`]: idleStop(n, 'ErrorCorrection'),
  [`motor${n}Angle`]: output<MotorJointNode>(
    (joint) => joint.motorAngle(n),
    {
      doc: `Angle about axis ${n}, radians: of body1 relative to body2 with autoCalc, else axis${n}Angle.`,
    },
    { angle: 1 },
  ),
  [`motor${n}AngleRate`]: output<MotorJointNode>(
    (joint) => joint.motorAngleRate(n),
    { doc: `Rate about axis ${n} of body1 relative to body2, rad/s.` },
    { angle: 1 },
  ),
});

export const motorFields: Record<string, MotorField> = {
  ...jointFields,
  autoCalc: {
    type: 'SFBool',
    access: 'initializeOnly',
    default: false,
    edit: 'rebuild',
    doc: 'TRUE: the angles are measured, as Euler angles about axis 1 (of body1), axis 3 (of body2) and the one across. FALSE: the author tells them.',
  },
  enabledAxes: {
    type: 'SFInt32',
    access: 'inputOutput',
    default: 1,
    range: [0, 3],
    edit: 'live',
    patch: torque,
    doc: 'How many axes are driven: 0 to 3.',
  },
  ...fieldsOf(1, [1, 0, 0]),
  ...fieldsOf(2, [0, 1, 0]),
  ...fieldsOf(3, [0, 0, 1]),
};
