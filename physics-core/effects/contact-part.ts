import type { Ammo } from '../engine/ammo.js';
import { MANIFOLD_POINT as POINT } from '../engine/offsets.js';
import type { Vec3 } from '../fields/types.js';
import { compose, invert, rotate, add } from '../math.js';
import type { BodyNode } from '../nodes/body.js';
import type { CollidableNode, CollidablePart } from '../nodes/collidable.js';
import { boundsOf } from '../shapes/mass.js';
import { tessellate } from '../shapes/tessellate.js';

/**
 * The collidable of a body that a contact point lies on; `side` 0 is the manifold's first body. Bullet numbers the
 * children of a compound, but a triangle of a mesh child overwrites that number with its own.
 */
export function partAt(
  ammo: Ammo,
  body: BodyNode,
  point: number,
  side: 0 | 1,
): CollidableNode | undefined {
  const parts = body.solidParts;
  if (parts.length <= 1) return parts[0]?.collidable;
  const heap = ammo.HEAP32;
  const index = heap[(point + (side === 0 ? POINT.index0 : POINT.index1)) >> 2]!;
  const triangle = heap[(point + (side === 0 ? POINT.part0 : POINT.part1)) >> 2]! >= 0;
  if (!triangle) return parts[index]?.collidable;
  const at = (point + POINT.positionB) >> 2;
  const position = ammo.HEAPF32.subarray(at, at + 3);
  return meshPartAt(body, [position[0]!, position[1]!, position[2]!]);
}

/** Whether it is a ball that the point lies on, which touches anything in one point. */
export function isBallAt(ammo: Ammo, body: BodyNode, point: number, side: 0 | 1): boolean {
  const parts = body.solidParts;
  if (parts.length <= 1) return parts[0]?.geometry.type === 'Sphere';
  const heap = ammo.HEAP32;
  if (heap[(point + (side === 0 ? POINT.part0 : POINT.part1)) >> 2]! >= 0) return false;
  const index = heap[(point + (side === 0 ? POINT.index0 : POINT.index1)) >> 2]!;
  return parts[index]?.geometry.type === 'Sphere';
}

/** Whether any part of it is a ball. */
export const isRound = (body: BodyNode): boolean =>
  body.solidParts.some(({ geometry }) => geometry.type === 'Sphere');

/** The mesh among the parts of a body that lies nearest to a point, world frame. */
export function meshPartAt(body: BodyNode, position: Vec3): CollidableNode | undefined {
  const meshes = body.solidParts.filter(({ mesh }) => mesh);
  if (meshes.length <= 1) return meshes[0]?.collidable;
  const toBody = invert(body.pose());
  const local = add(toBody.p, rotate(toBody.q, position));
  const distances = meshes.map((part) => distanceTo(part, local));
  return meshes[distances.indexOf(Math.min(...distances))]!.collidable;
}

/** From the box around a part to a point in the body's frame. */
function distanceTo({ geometry, pose }: CollidablePart, point: Vec3): number {
  const { min, max } = boundsOf(tessellate(geometry).points);
  const local = compose(invert(pose), { p: point, q: [0, 0, 0, 1] }).p;
  return Math.hypot(...local.map((value, i) => Math.max(min[i]! - value, 0, value - max[i]!)));
}

/** The least extent of anything solid of a body, metres; Infinity where it is all triangles. */
export function thicknessOf(body: BodyNode): number {
  const solid = body.solidParts.filter(({ mesh }) => !mesh);
  const extents = solid.flatMap(({ geometry }) => {
    const { min, max } = boundsOf(tessellate(geometry).points);
    return max.map((value, i) => value - min[i]!);
  });
  return Math.min(Infinity, ...extents);
}
