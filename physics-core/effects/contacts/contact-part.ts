import type { ContactPoint } from '../../engine/contact-point.js';
import type { Vec3 } from '../../fields/types.js';
import type { Body } from '../../dynamics/body.js';
import type { Collidable, CollidablePart } from '../../dynamics/collidable.js';
import { distanceTo, within } from './part-distance.js';

/**
 * The number among the solid parts of a body of the one that a contact point lies on; `side` 0 is the manifold's first
 * body. Bullet numbers the children of a compound, but a triangle of a mesh child overwrites that number with its own.
 */
export function partNumberAt(point: ContactPoint, body: Body, side: 0 | 1): number {
  if (body.solidParts.length <= 1) return 0;
  if (!point.onTriangle(side)) return point.child(side);
  return meshNumberAt(body, point.positionVector());
}

/** The part of a body that a contact point lies on. */
export const partOf = (point: ContactPoint, body: Body, side: 0 | 1): CollidablePart | undefined =>
  body.solidParts[partNumberAt(point, body, side)];

/** The collidable of a body that a contact point lies on. */
export const partAt = (point: ContactPoint, body: Body, side: 0 | 1): Collidable | undefined =>
  partOf(point, body, side)?.collidable;

/** The parts of both bodies that a contact point lies on, as one number; it holds as long as their shapes. */
export const partsAt = (point: ContactPoint, a: Body, b: Body): number =>
  partNumberAt(point, a, 0) * b.solidParts.length + partNumberAt(point, b, 1);

/** Whether it is a ball that the point lies on, which touches anything in one point. */
export function isBallAt(point: ContactPoint, body: Body, side: 0 | 1): boolean {
  const part = partOf(point, body, side);
  return part?.geometry.type === 'Sphere' && !part.mesh;
}

/** Whether any part of it is a ball. */
export const isRound = (body: Body): boolean =>
  body.solidParts.some(({ geometry }) => geometry.type === 'Sphere');

/** The number of the mesh among the solid parts of a body whose box lies nearest to a point, world frame. */
function meshNumberAt(body: Body, position: Vec3): number {
  const local = within(body.poseInBullet(), position);
  let nearest = 0;
  let least = Infinity;
  body.solidParts.forEach((part, i) => {
    const distance = part.mesh ? distanceTo(part, local) : Infinity;
    if (distance < least) {
      nearest = i;
      least = distance;
    }
  });
  return nearest;
}
