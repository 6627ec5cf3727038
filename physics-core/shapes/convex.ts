import type { Vec3 } from '../fields/types.js';
import { cross, dot, length, subtract } from '../base/math.js';
import type { Mesh } from './geometry.js';
import type { Hull } from './hull.js';
import { boundsOf } from './bounds.js';

/**
 * Share of its size by which a point of a convex mesh may stand out: single precision lets those of a finely divided face
 * stand out by 8e-7, ten sizes from the origin by 7e-6, and so do six decimals in a file (measured).
 */
const FLAT = 1e-5;

const pointOf = ({ points }: Mesh, i: number): Vec3 => [
  points[3 * i]!,
  points[3 * i + 1]!,
  points[3 * i + 2]!,
];

function centreOf(mesh: Mesh, { corners }: Hull): Vec3 {
  const centre: Vec3 = [0, 0, 0];
  for (const corner of corners)
    pointOf(mesh, corner).forEach((value, axis) => (centre[axis]! += value / corners.length));
  return centre;
}

/** From one point of a hull to the highest: on a convex body no other top is in the way. */
function climb({ neighbours }: Hull, from: number, height: (point: number) => number): number {
  for (let [at, top] = [from, height(from)]; ;) {
    let next = at;
    for (const neighbour of neighbours.get(at)!) {
      const value = height(neighbour);
      if (value > top) [next, top] = [neighbour, value];
    }
    if (next === at) return top;
    at = next;
  }
}

/** Whether every point of a mesh lies behind every one of its triangles; its hull is undefined where it lies in one plane. */
export function isConvex(mesh: Mesh, hull: Hull | undefined): boolean {
  if (!hull) return true;
  const { min, max } = boundsOf(mesh.points);
  const extent = length(subtract(max, min));
  const centre = centreOf(mesh, hull);
  for (let t = 0; t < mesh.index.length; t += 3) {
    const [i, j, k] = [mesh.index[t]!, mesh.index[t + 1]!, mesh.index[t + 2]!];
    const a = pointOf(mesh, i);
    const normal = cross(subtract(pointOf(mesh, j), a), subtract(pointOf(mesh, k), a));
    const size = length(normal);
    // A sliver has no direction; the poles of a sphere have such.
    if (size <= 1e-9 * extent * extent) continue;
    const above = (point: Vec3): number => dot(subtract(point, a), normal) / size;
    const tolerance = FLAT * extent;
    // Where the centre is above, a climb from the bottom could find nothing but bottom around it.
    if (above(centre) > tolerance) return false;
    const from = hull.neighbours.has(i) ? i : hull.corners[0]!;
    if (climb(hull, from, (point) => above(pointOf(mesh, point))) > tolerance) return false;
  }
  return true;
}
