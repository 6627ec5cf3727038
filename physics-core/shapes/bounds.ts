import type { Vec3 } from '../fields/types.js';

/** A box along the axes. */
export interface Bounds {
  min: Vec3;
  max: Vec3;
}

/** Around points, x y z each. */
export function boundsOf(points: ArrayLike<number>): Bounds {
  const min: Vec3 = [Infinity, Infinity, Infinity];
  const max: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    const axis = i % 3;
    min[axis] = Math.min(min[axis]!, points[i]!);
    max[axis] = Math.max(max[axis]!, points[i]!);
  }
  return { min, max };
}
