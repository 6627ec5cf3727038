import { cross } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { Joint } from '../../dynamics/joint.js';
import { levels } from '../../dynamics/levels.js';
import type { Reported } from '../effect/reported.js';
import { isDirected, type AxedJoint } from './axes.js';

export interface ReportedJoint extends Pick<Joint, 'body1' | 'body2'>, Reported {}

export interface ReportedMotor extends AxedJoint {
  authored(field: string): boolean;
}

/** With masses more unlike than this a chain whips faster than steps of `standard` follow (measured: 5 mm off in 1 s). */
const HARD_MASS_RATIO = 100;

export function reportBodies(joint: ReportedJoint): void {
  const { body1, body2, label } = joint;
  joint.reportWhile(!body1 && !body2, {
    code: 'no-body',
    severity: 'warning',
    used: 'nothing',
    message: `${label} names no body and holds nothing until body1 or body2 does`,
  });
  joint.reportWhile(body1 !== undefined && body1 === body2, {
    code: 'same-body',
    severity: 'warning',
    attribute: 'body2',
    used: 'nothing',
    message: `${label} names ${body1?.label} as body1 and as body2 and holds nothing until they differ`,
  });
}

export function reportMassRatio(joint: ReportedJoint): void {
  const { body1, body2, label } = joint;
  const masses = [body1, body2].map((body) => (body?.movable ? body.mass.mass : 0));
  const ratio = Math.max(...masses) / Math.min(...masses);
  joint.reportWhile(Number.isFinite(ratio) && ratio > HARD_MASS_RATIO, {
    code: 'mass-ratio',
    severity: 'warning',
    value: ratio,
    used: 'the present accuracy',
    message: `${label} holds ${body1?.label} (${masses[0]} kg) to ${body2?.label} (${masses[1]} kg): so unlike masses hold, but whip about faster than coarse steps follow: accuracy="fine" or better keeps their way true`,
  });
}

/** Metres or radians by which no joint is to be open after a step. */
export const GAPING = 1e-3;

/** What a step leaves of a joint that is pulled hard shrinks with the square of its length. */
export function reportGap(joint: Joint, gap: number, dt: number): void {
  const better = levels.find(
    ({ timeStep }) => timeStep < dt && gap * (timeStep / dt) ** 2 < GAPING,
  );
  joint.report({
    code: 'joint-gap',
    severity: 'warning',
    value: gap,
    used: 'the present accuracy',
    message: `${joint.label} is pulled open by ${Number((gap * 1000).toPrecision(2))} mm (or thousandths of a radian): steps of ${Number((dt * 1000).toPrecision(2))} ms do not hold what weighs on it or strikes it; ${better ? `accuracy="${better.name}" or better, ` : ''}masses more alike or more slack would`,
  });
}

const AXES = [1, 2, 3] as const;

/** Fields of a motor that look as if they turned something, and do not; each by the field that it takes to turn. */
export function reportIdle(motor: ReportedMotor): void {
  const driven = AXES.filter((n) => motor.asked<number>(`axis${n}Torque`) !== 0);
  reportEnabled(motor, driven.at(-1));
  for (const n of AXES) {
    reportAxis(motor, n, driven.includes(n));
    reportAngle(motor, n);
  }
}

const idle = (motor: ReportedMotor, is: boolean, attribute: string, why: string): void =>
  motor.reportWhile(is, {
    code: 'idle-motor',
    severity: 'warning',
    attribute,
    used: 'no torque',
    message: `${motor.label}: ${why}`,
  });

function reportAxis(motor: ReportedMotor, n: number, driven: boolean): void {
  const axis = `motor${n}Axis`;
  if (n === 2 && motor.asked<boolean>('autoCalc')) return reportSecond(motor, driven);
  const is = driven && !isDirected(motor.asked<Vec3>(axis));
  idle(motor, is, axis, `${axis}="0 0 0" has no direction, so axis${n}Torque turns nothing`);
}

/** In Euler mode the second axis stands at right angles to the two others, and motor2Axis says nothing. */
function reportSecond(motor: ReportedMotor, driven: boolean): void {
  const second = cross(motor.asked<Vec3>('motor3Axis'), motor.asked<Vec3>('motor1Axis'));
  const why =
    'with autoCalc the second axis is at right angles to motor1Axis and motor3Axis; those have no two directions, so axis2Torque turns nothing';
  idle(motor, driven && !isDirected(second), 'motor2Axis', why);
}

/** Who wrote enabledAxes means it: that is how motors are switched off. */
function reportEnabled(motor: ReportedMotor, last = 0): void {
  const enabled = motor.asked<number>('enabledAxes');
  const is = last > enabled && !motor.authored('enabledAxes');
  const why = `axis${last}Torque turns nothing, since enabledAxes is ${enabled}; write enabledAxes="${last}"`;
  idle(motor, is, 'enabledAxes', why);
}

/** An angle without any torque was meant as a target. */
function reportAngle(motor: ReportedMotor, n: number): void {
  const angle = `axis${n}Angle`;
  const torque = `axis${n}Torque`;
  const wanted = motor.asked<number>(angle) !== 0;
  const is = wanted && !AXES.some((axis) => motor.authored(`axis${axis}Torque`));
  idle(motor, is, torque, `${angle} is no target and turns nothing; a motor turns by ${torque}`);
}
