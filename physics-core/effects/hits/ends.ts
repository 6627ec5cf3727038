import { hypot, lengthOf } from '../../base/exact/index.js';
import { add, conjugate, cross, rotate, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Vec3 } from '../../fields/types.js';
import { boxOf } from '../contacts/part-box.js';

/**
 * How fast, m/s, the ends of a body go round its centre of mass by a spin, both in its frame. A ball has none but its middle,
 * what is round about its own axis goes round into itself, and anything ends half its least extent before its corners: that
 * far it is as thick as there.
 */
export function speedOfEnds(body: Body, spin: Vec3): number {
  let most = 0;
  for (const part of body.solidParts)
    if (!part.mesh) most = Math.max(most, speedOfPart(part, body.centerOfMass.p, spin));
  return most;
}

function speedOfPart(part: CollidablePart, centre: Vec3, spin: Vec3): number {
  const { min, max } = boxOf(part);
  const middle = max.map((value, i) => (value + min[i]!) / 2) as Vec3;
  const half = max.map((value, i) => (value - min[i]!) / 2) as Vec3;
  const least = Math.min(...half);
  const end = half.map((value) => value - least) as Vec3;
  const { p, q } = part.pose;
  const carried = cross(spin, subtract(add(p, rotate(q, middle)), centre));
  const [x, y, z] = rotate(conjugate(q), spin);
  if (part.outline?.kind === 'frustum')
    return lengthOf(carried) + hypot(x, z) * hypot(end[0], end[1]);
  const along = rotate(conjugate(q), carried);
  let most = 0;
  for (let k = 0; k < 8; k++) {
    const corner = end.map((value, i) => (k & (1 << i) ? -value : value)) as Vec3;
    most = Math.max(most, lengthOf(add(along, cross([x, y, z], corner))));
  }
  return most;
}
