import { AXES, compose, conjugate, rotate } from '../base/math.js';
import type { Vec3 } from '../fields/types.js';
import type { Body } from './body.js';

/** What an angular impulse does to the spin of a body, world frame. */
export const applyInverseInertia = (body: Inert, v: Vec3): Vec3 => byMoments(body, v, -1);

/** The angular momentum of a spin, world frame. */
export const applyInertia = (body: Inert, v: Vec3): Vec3 => byMoments(body, v, 1);

type Inert = Pick<Body, 'pose' | 'centerOfMass' | 'mass'>;

function byMoments(body: Inert, v: Vec3, power: 1 | -1): Vec3 {
  const { q } = compose(body.pose(), body.centerOfMass);
  const { moments } = body.mass;
  const [x, y, z] = rotate(conjugate(q), v);
  return rotate(q, [x * moments[0] ** power, y * moments[1] ** power, z * moments[2] ** power]);
}

/** Of the world's axes, a column each: what a moment about it does to the spin of a body. */
export const inverseInertiaOf = (body: Inert): Float64Array =>
  Float64Array.from(AXES.flatMap((axis) => applyInverseInertia(body, axis)));
