import { quaternionOf } from '../../../../physics-core/base/math.js';
import type { RollingEllipsoid } from '../../../../references/rolling-ellipsoid.js';
import type { Rotation } from '../../../../physics-core/fields/types.js';
import { addBody, addFloor, world, type Body, type Vec3 } from '../../helpers.js';
import { G } from './scenes.js';

// What is round, and touched elsewhere in each moment.

/** An egg as X3D has it: a Sphere in a Transform that scales. */
export const ellipsoid = ([x, y, z]: Vec3) => ({
  type: 'Sphere',
  radius: 1,
  linear: [x, 0, 0, 0, y, 0, 0, 0, z],
});

/** How a rattleback lies that hardly leans, as axis and angle. */
const LEANS: Rotation = [0, 0, 1, 0.01];

/** A stone of 20 cm whose weight lies 0.15 rad askew to its length; it spins by so many rad/s. */
export function rattleback(rate: number): RollingEllipsoid {
  const [a, b, c] = [0.1, 0.02, 0.03];
  const mass = 0.1;
  const [along, up, across] = [b ** 2 + c ** 2, a ** 2 + c ** 2, a ** 2 + b ** 2].map(
    (square) => (mass * square) / 5,
  ) as Vec3;
  const [cos, sin] = [Math.cos(0.15), Math.sin(0.15)];
  const askew = cos * sin * (along - across);
  return {
    half: [a, b, c],
    mass,
    inertia: [
      ...[cos ** 2 * along + sin ** 2 * across, 0, askew],
      ...[0, up, 0],
      ...[askew, 0, sin ** 2 * along + cos ** 2 * across],
    ],
    gravity: G,
    orientation: quaternionOf(LEANS),
    spin: [0, rate, 0],
  };
}

/** A world with a floor of this friction. */
export async function onFloor(accuracy: string, friction: number) {
  const w = await world({ accuracy });
  w.set('rest', 'never');
  addFloor(w);
  w.add('CollisionCollection', {
    collidables: '*',
    appliedParameters: ['FRICTION_COEFFICIENT-2'],
    frictionCoefficients: [friction, friction],
    bounce: 0,
  });
  return w;
}

export interface Egg {
  half: Vec3;
  mass: number;
  orientation: Rotation;
  angularVelocity?: Vec3;
}

/** On the floor, its inertia that of an even solid. */
export const addEgg = (
  w: Awaited<ReturnType<typeof world>>,
  { half, ...fields }: Egg,
  height: number,
): Body => addBody(w, { ...fields, position: [0, height, 0], geometry: [ellipsoid(half)] });

/** As a rattleback of the reference begins. */
export const addRattleback = (
  w: Awaited<ReturnType<typeof world>>,
  { half, mass, inertia, spin }: RollingEllipsoid,
  height: number,
  velocity: Vec3,
): Body =>
  addBody(w, {
    mass,
    inertia,
    position: [0, height, 0],
    orientation: LEANS,
    linearVelocity: velocity,
    angularVelocity: spin,
    geometry: [ellipsoid(half)],
  });
