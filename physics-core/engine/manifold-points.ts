import type { Ammo } from './ammo.js';
import { MANIFOLD, MANIFOLD_POINT as POINT } from './offsets.js';

// What effects read from contact points of Bullet, and write into them.

/** Farther than any contact that Bullet's solver looks at (its own threshold is 1e18), metres. */
export const APART = 1e30;

/** The solver finds the point so far away, metres. */
export function setSolverDistanceAt({ HEAPF32 }: Ammo, point: number, metres: number): void {
  HEAPF32[(point + POINT.distance) >> 2] = metres;
}

/** The distance of a point as the solver has it, metres. */
export const solverDistanceAt = ({ HEAPF32 }: Ammo, point: number): number =>
  HEAPF32[(point + POINT.distance) >> 2]!;

/** From now on it has no contact point. */
export function forgetPoints({ HEAP32 }: Ammo, manifold: number): void {
  HEAP32[(manifold + MANIFOLD.pointCount) >> 2] = 0;
}

/** How far a point may move and still be the same, metres. */
export const breakingAt = ({ HEAPF32 }: Ammo, manifold: number): number =>
  HEAPF32[(manifold + MANIFOLD.breaking) >> 2]!;

/** Pointer of the first point of a manifold's pointer, 0 where it has none. */
export const firstPointAt = ({ HEAP32 }: Ammo, manifold: number): number =>
  HEAP32[(manifold + MANIFOLD.pointCount) >> 2] === 0 ? 0 : manifold + MANIFOLD.points;

/** The normal of its deepest point, from B into A. Returns the distance there, metres; Infinity: it has no point. */
export function writeDeepestNormal(
  { HEAP32, HEAPF32 }: Ammo,
  manifold: number,
  out: Float64Array,
): number {
  let least = Infinity;
  for (let i = 0; i < HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!; i++) {
    const point = manifold + MANIFOLD.points + i * POINT.size;
    const distance = HEAPF32[(point + POINT.distance) >> 2]!;
    if (distance >= least) continue;
    least = distance;
    for (let k = 0; k < 3; k++) out[k] = HEAPF32[((point + POINT.normalB) >> 2) + k]!;
  }
  return least;
}
