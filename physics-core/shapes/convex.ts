import type { Mesh } from './geometry.js';
import { boundsOf } from './mass.js';

/**
 * Share of its size by which a point of a convex mesh may stand out: single precision lets those of a finely divided face
 * stand out by 8e-7, ten sizes from the origin by 7e-6, and so do six decimals in a file (measured).
 */
const FLAT = 1e-5;

/** Whether every point of a mesh lies behind every one of its triangles. */
export function isConvex({ points, index }: Mesh): boolean {
  const { min, max } = boundsOf(points);
  const extent = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const tolerance = FLAT * extent;
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [index[t]! * 3, index[t + 1]! * 3, index[t + 2]! * 3];
    const [ux, uy, uz] = [
      points[b]! - points[a]!,
      points[b + 1]! - points[a + 1]!,
      points[b + 2]! - points[a + 2]!,
    ];
    const [vx, vy, vz] = [
      points[c]! - points[a]!,
      points[c + 1]! - points[a + 1]!,
      points[c + 2]! - points[a + 2]!,
    ];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const size = Math.hypot(nx, ny, nz);
    // A sliver has no direction; the poles of a sphere have such.
    if (size <= 1e-9 * extent * extent) continue;
    for (let i = 0; i < points.length; i += 3) {
      const height =
        ((points[i]! - points[a]!) * nx +
          (points[i + 1]! - points[a + 1]!) * ny +
          (points[i + 2]! - points[a + 2]!) * nz) /
        size;
      if (height > tolerance) return false;
    }
  }
  return true;
}
