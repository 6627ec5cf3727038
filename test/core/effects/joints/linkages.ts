import { add, scale, subtract } from '../../../../physics-core/base/math.js';
import type { World } from '../../../../physics-core/inside.js';
import { addBody, addJoint, box, type Body, type Hinge, type Vec3 } from '../../helpers.js';

export const G = 9.8;

/** A thin rod of 1 kg between two points in the plane of x and y; it turns about the first, rad/s. */
export function addRod(w: World, from: Vec3, to: Vec3, turning = 0): Body {
  const along = subtract(to, from);
  return addBody(w, {
    angularVelocity: [0, 0, turning],
    linearVelocity: scale([-along[1], along[0], 0], turning / 2),
    position: scale(add(from, to), 0.5),
    orientation: [0, 0, 1, Math.atan2(along[1], along[0])],
    geometry: [box(Math.hypot(...along), 0.02, 0.02)],
  });
}

export const hinge = (
  w: World,
  at: Vec3,
  body1: Body,
  body2?: Body,
  axis: Vec3 = [0, 0, 1],
): Hinge =>
  addJoint(w, 'SingleAxisHingeJoint', { body1, ...(body2 && { body2 }), axis, anchorPoint: at });

/** Nothing collides: only joints count. */
export const quiet = (w: World): void =>
  void w.add('CollisionCollection', { collidables: '*', enabled: false });

/** Ground 2 m, crank 1 m, coupler 2 m, rocker 2 m: a crank that goes round. */
export const [GROUND, CRANK, COUPLER, ROCKER] = [2, 1, 2, 2];

/** Where the rocker's end is for an angle of the crank: where two circles meet, above. */
export function meeting(crank: number): Vec3 {
  const [x, y] = [CRANK * Math.cos(crank), CRANK * Math.sin(crank)];
  const [dx, dy] = [GROUND - x, -y];
  const d = Math.hypot(dx, dy);
  const along = (COUPLER ** 2 - ROCKER ** 2 + d * d) / (2 * d);
  const across = Math.sqrt(COUPLER ** 2 - along ** 2);
  return [x + (dx * along - dy * across) / d, y + (dy * along + dx * across) / d, 0];
}

export function addFourBar(w: World): { bars: Body[]; joints: Hinge[] } {
  const [a, b, c, d]: Vec3[] = [[0, 0, 0], [0, 1, 0], meeting(Math.PI / 2), [GROUND, 0, 0]];
  const bars = [addRod(w, a!, b!), addRod(w, b!, c!), addRod(w, d!, c!)];
  const [crank, coupler, rocker] = bars as [Body, Body, Body];
  const joints = [
    hinge(w, a!, crank),
    hinge(w, b!, coupler, crank),
    hinge(w, c!, rocker, coupler),
    hinge(w, d!, rocker),
  ];
  return { bars, joints };
}
