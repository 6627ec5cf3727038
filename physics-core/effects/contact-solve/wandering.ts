import { conjugate, cross, dot, multiply, rotate, scale, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { ContactPoint } from '../../engine/contact-point.js';
import type { Vec3 } from '../../fields/types.js';
import type { Tensor } from '../../shapes/mass.js';
import { partOf } from '../contacts/contact-part.js';

/**
 * What is round there, and touched elsewhere on it in each moment while it turns: an ellipsoid, or a ball whose middle is not
 * the centre of mass. `side` 0 is the manifold's first body.
 */
export function rollingPartAt(
  point: ContactPoint,
  body: Body,
  side: 0 | 1,
): CollidablePart | undefined {
  const part = partOf(point, body, side);
  const kind = part?.outline?.kind;
  if (kind === 'ellipsoid') return part;
  return kind === 'ball' && !isCentral(part!, body) ? part : undefined;
}

function isCentral({ pose }: CollidablePart, { centerOfMass }: Body): boolean {
  const [x, y, z] = pose.p;
  const [cx, cy, cz] = centerOfMass.p;
  return x === cx && y === cy && z === cz;
}

/**
 * How fast the place where it is touched wanders over it while it turns by `spin` and is touched from the same direction, m/s
 * in the world. `outwards` has the length 1.
 */
export function wandering(
  { outline, pose }: CollidablePart,
  body: Body,
  outwards: Vec3,
  spin: Vec3,
): Vec3 {
  // As the body sees it, the direction turns the other way.
  const turning = cross(outwards, spin);
  if (outline?.kind !== 'ellipsoid')
    return scale(turning, outline?.kind === 'ball' ? outline.radius : 0);
  const frame = multiply(body.poseInBullet().q, pose.q);
  const within = conjugate(frame);
  return rotate(
    frame,
    onEllipsoid(outline.squares, rotate(within, outwards), rotate(within, turning)),
  );
}

/** How the point M d / √(dᵀ M d), farthest along d, changes with d. */
function onEllipsoid(squares: Tensor, direction: Vec3, turning: Vec3): Vec3 {
  const far = times(squares, direction);
  const square = dot(direction, far);
  const turned = times(squares, turning);
  return scale(
    subtract(turned, scale(far, dot(direction, turned) / square)),
    1 / Math.sqrt(square),
  );
}

const times = ([xx, yy, zz, xy, xz, yz]: Tensor, [x, y, z]: Vec3): Vec3 => [
  xx * x + xy * y + xz * z,
  xy * x + yy * y + yz * z,
  xz * x + yz * y + zz * z,
];

/** Whether what touches it there touches a face of it, as far as one knows: it goes on being touched in that plane. */
export function isFlatAt(point: ContactPoint, body: Body, side: 0 | 1): boolean {
  const kind = partOf(point, body, side)?.outline?.kind;
  return kind === 'box' || kind === 'hull' || kind === 'triangles';
}
