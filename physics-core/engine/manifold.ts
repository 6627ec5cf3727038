import { guards } from '../base/guards.js';
import type { Ammo } from './ammo.js';
import { MANIFOLD, MANIFOLD_POINT as POINT } from './offsets.js';

// Bullet's contact points of two bodies near each other; only where the heap is trusted.

export type Manifold = Ammo['btPersistentManifold']['prototype'];

/** Pointer of its first contact point; it must have one. The others follow. */
export const firstPoint = (ammo: Ammo, manifold: Manifold): number =>
  ammo.getPointer(manifold.getContactPoint(0));

/** Pointer of the contact point `i` after another one of the same manifold. */
export const pointAfter = (first: number, i: number): number => first + i * POINT.size;

/** How many contact points it has; its bodies. */
export const pointCountAt = ({ HEAP32 }: Ammo, manifold: number): number =>
  HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
export const bodyAAt = ({ HEAP32 }: Ammo, manifold: number): number =>
  HEAP32[(manifold + MANIFOLD.bodyA) >> 2]!;
export const bodyBAt = ({ HEAP32 }: Ammo, manifold: number): number =>
  HEAP32[(manifold + MANIFOLD.bodyB) >> 2]!;

/** The pointer of its contact point `i`. */
export const pointAt = (manifold: number, i: number): number =>
  pointAfter(manifold + MANIFOLD.points, i);

/** Farther than any contact that Bullet's solver looks at (its own threshold is 1e18), metres. */
export const APART = 1e30;

/** The solver finds the point so far away, metres. */
export function setSolverDistanceAt({ HEAPF32 }: Ammo, point: number, metres: number): void {
  HEAPF32[(point + POINT.distance) >> 2] = metres;
}

/** Visits the pointers of its contact points. */
export function eachPoint(ammo: Ammo, manifold: number, visit: (point: number) => void): void {
  const count = ammo.HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
  for (let i = 0; i < count; i++) visit(pointAfter(manifold + MANIFOLD.points, i));
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

/** The solver's next step does not start from what went through its points in the last one. */
export function forgetImpulses(ammo: Ammo, manifold: number): void {
  const { HEAPF32 } = ammo;
  eachPoint(ammo, manifold, (point) => {
    for (const at of [POINT.impulse, POINT.lateralImpulse1, POINT.lateralImpulse2])
      HEAPF32[(point + at) >> 2] = guards.impulseOfOtherMass(HEAPF32[(point + at) >> 2]!);
  });
}

/** Sorts the manifolds of one pair by the parts that they are of; one without points comes first. */
export function childKeyAt({ HEAP32 }: Ammo, manifold: number): number {
  if (HEAP32[(manifold + MANIFOLD.pointCount) >> 2] === 0) return -1;
  const point = (manifold + MANIFOLD.points) >> 2;
  return HEAP32[point + POINT.index0 / 4]! * MOST_PARTS + HEAP32[point + POINT.index1 / 4]!;
}

/** Triangles of a mesh, at most: numbers of parts and of triangles stand side by side. */
const MOST_PARTS = 2 ** 24;
