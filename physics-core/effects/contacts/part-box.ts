import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Bounds } from '../../shapes/bounds.js';
import { boxAround } from '../../shapes/meshes.js';

/** Boxes around parts, each in its own frame. A body whose shape changes has new parts. */
const boxes = new WeakMap<CollidablePart, Bounds>();

export function boxOf(part: CollidablePart): Bounds {
  let box = boxes.get(part);
  if (!box) boxes.set(part, (box = boxAround(part.geometry)));
  return box;
}

/** The least extent of anything solid of a body, metres; Infinity where it is all triangles. */
export function thicknessOf(body: Body): number {
  const extents = body.solidParts.flatMap((part) => {
    if (part.mesh) return [];
    const { min, max } = boxOf(part);
    return max.map((value, i) => value - min[i]!);
  });
  return Math.min(Infinity, ...extents);
}
