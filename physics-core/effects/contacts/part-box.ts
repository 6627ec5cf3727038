import { lengthOf } from '../../base/exact/index.js';
import { add, rotate, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Vec3 } from '../../fields/types.js';
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

/** How far anything solid of a body reaches from its centre of mass, metres. */
export function reachOf(body: Body): number {
  let most = 0;
  for (const part of body.solidParts) {
    const { min, max } = boxOf(part);
    for (let k = 0; k < 8; k++) {
      const corner = max.map((value, i) => (k & (1 << i) ? min[i]! : value)) as Vec3;
      const { p, q } = part.pose;
      most = Math.max(most, lengthOf(subtract(add(p, rotate(q, corner)), body.centerOfMass.p)));
    }
  }
  return most;
}
