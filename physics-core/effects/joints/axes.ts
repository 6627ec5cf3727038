import { cross, length, normalize, perpendicular } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { Reported } from '../effect/reported.js';

/** A joint with axes that its author wrote. */
export interface AxedJoint extends Reported {
  readonly type: { readonly fields: Readonly<Record<string, { default: unknown }>> };
  asked<T>(field: string): T;
}

/** An authored axis that can't be used as it is. */
export interface OddAxis {
  attribute: string;
  used: Vec3;
  why: string;
}

export function reportAxis(joint: AxedJoint, is: boolean, { attribute, used, why }: OddAxis): void {
  const shown = used.map((n) => Number(n.toFixed(4))).join(' ');
  const value = joint.asked<Vec3>(attribute);
  joint.reportWhile(is, {
    code: 'bad-value',
    severity: 'warning',
    attribute,
    value,
    used,
    message: `${joint.label}: ${attribute}="${value.join(' ')}" ${why}; ${shown} is used`,
  });
}

export const isDirected = (axis: Vec3): boolean => length(axis) > 1e-9;

/** The authored axis, or X3D 4.0's default after a report where it has no direction. */
export function direction(joint: AxedJoint, attribute: string): Vec3 {
  const axis = joint.asked<Vec3>(attribute);
  const directed = isDirected(axis);
  const used = joint.type.fields[attribute]!.default as Vec3;
  reportAxis(joint, !directed, { attribute, used, why: 'has no direction' });
  return directed ? normalize(axis) : [...used];
}

/** Sine of the angle between two axes below which they count as one. */
const PARALLEL = 0.05;

/** The second axis, or one at right angles to the first after a report where both are nearly one. */
export function notAlong(joint: AxedJoint, axis1: Vec3, attribute: string): Vec3 {
  const axis2 = direction(joint, attribute);
  if (length(cross(axis1, axis2)) > PARALLEL) return axis2;
  const used = perpendicular(axis1);
  reportAxis(joint, true, { attribute, used, why: 'runs along the first axis' });
  return used;
}
