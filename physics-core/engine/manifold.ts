import type { Ammo } from './ammo.js';
import { MANIFOLD, MANIFOLD_POINT as POINT } from './offsets.js';

// Bullet's contact points of two bodies near each other; only where the heap is trusted.

export type Manifold = Ammo['btPersistentManifold']['prototype'];

/** Pointer of its first contact point; it must have one. The others follow. */
export const firstPoint = (ammo: Ammo, manifold: Manifold): number =>
  ammo.getPointer(manifold.getContactPoint(0));

/** Pointer of the contact point `i` after another one of the same manifold. */
export const pointAfter = (first: number, i: number): number => first + i * POINT.size;

/** Visits the pointers of its contact points. */
export function eachPoint(ammo: Ammo, manifold: number, visit: (point: number) => void): void {
  const count = ammo.HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
  for (let i = 0; i < count; i++) visit(pointAfter(manifold + MANIFOLD.points, i));
}

/** The distance of a point as the solver has it, metres. */
export const solverDistanceAt = ({ HEAPF32 }: Ammo, point: number): number =>
  HEAPF32[(point + POINT.distance) >> 2]!;

/** How far a point may move and still be the same, metres. */
export const breakingOf = (ammo: Ammo, manifold: Manifold): number =>
  ammo.HEAPF32[(ammo.getPointer(manifold) + MANIFOLD.breaking) >> 2]!;

/** From now on it has no contact point. */
export function forgetPoints(ammo: Ammo, manifold: Manifold): void {
  ammo.HEAP32[(ammo.getPointer(manifold) + MANIFOLD.pointCount) >> 2] = 0;
}

/** The same of a manifold's pointer. */
export const breakingAt = ({ HEAPF32 }: Ammo, manifold: number): number =>
  HEAPF32[(manifold + MANIFOLD.breaking) >> 2]!;

/** The number that its first point has for the child of a compound, -1 where it has no point; `side` 0 is A. */
export function childAt({ HEAP32 }: Ammo, manifold: number, side: 0 | 1): number {
  if (HEAP32[(manifold + MANIFOLD.pointCount) >> 2] === 0) return -1;
  const index = side === 0 ? POINT.index0 : POINT.index1;
  return HEAP32[(manifold + MANIFOLD.points + index) >> 2]!;
}

/** The normal of its deepest point, from B into A. False: it has no point. */
export function writeDeepestNormal(
  { HEAP32, HEAPF32 }: Ammo,
  manifold: number,
  out: Float64Array,
): boolean {
  let least = Infinity;
  for (let i = 0; i < HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!; i++) {
    const point = manifold + MANIFOLD.points + i * POINT.size;
    const distance = HEAPF32[(point + POINT.distance) >> 2]!;
    if (distance >= least) continue;
    least = distance;
    for (let k = 0; k < 3; k++) out[k] = HEAPF32[((point + POINT.normalB) >> 2) + k]!;
  }
  return least < Infinity;
}
