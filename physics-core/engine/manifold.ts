import { guards } from '../base/guards.js';
import type { Ammo } from './ammo.js';
import { BODY, MANIFOLD, MANIFOLD_POINT as POINT, SHAPE, SHAPE_TYPE } from './offsets.js';

// Bullet's contact points of two bodies near each other.

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

/** Parts of a body, at most. */
const MOST_PARTS = 2 ** 24;

/** Whether a body is of several parts. */
export function isInParts({ HEAP32 }: Ammo, body: number): boolean {
  const shape = HEAP32[(body + BODY.shape) >> 2]!;
  return HEAP32[(shape + SHAPE.type) >> 2] === SHAPE_TYPE.compound;
}

/** Whether one of its bodies is. */
export const isOfParts = (ammo: Ammo, manifold: number): boolean =>
  isInParts(ammo, bodyAAt(ammo, manifold)) || isInParts(ammo, bodyBAt(ammo, manifold));

/** The number of a part, from what stands in a point: where a body is of one part, nobody wrote there. */
const partIn = (ammo: Ammo, body: number, index: number): number =>
  isInParts(ammo, body) ? index : 0;

/** Tells points of one pair apart by the parts that they are of. */
export const partsKey = (ammo: Ammo, a: number, b: number, index0: number, index1: number) =>
  partIn(ammo, a, index0) * MOST_PARTS + partIn(ammo, b, index1);

/** Sorts the manifolds of one pair by the parts that they are of; one without points comes first. */
export function partsKeyAt(ammo: Ammo, manifold: number): number {
  if (pointCountAt(ammo, manifold) === 0) return -1;
  const { HEAP32 } = ammo;
  const point = (manifold + MANIFOLD.points) >> 2;
  const index0 = HEAP32[point + POINT.index0 / 4]!;
  const index1 = HEAP32[point + POINT.index1 / 4]!;
  return partsKey(ammo, bodyAAt(ammo, manifold), bodyBAt(ammo, manifold), index0, index1);
}
