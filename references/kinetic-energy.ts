import { compose, conjugate, dot, rotate, type Quaternion } from '../physics-core/base/math.js';
import type { Vec3 } from '../physics-core/inside.js';
import type { BodyNode } from '../physics-core/nodes/body/body.js';

/** The way its principal axes lie, world frame. */
export const axesOf = (body: BodyNode): Quaternion => compose(body.pose(), body.centerOfMass).q;

/** Joules at a velocity of the centre of mass and a spin, world frame. */
export function kineticEnergy(
  { mass: { mass, moments } }: BodyNode,
  velocity: Vec3,
  spin: Vec3,
  axes: Quaternion,
): number {
  const turning = rotate(conjugate(axes), spin);
  const round = moments.reduce((sum, moment, axis) => sum + moment * turning[axis]! ** 2, 0);
  return (mass * dot(velocity, velocity) + round) / 2;
}
