import { guards } from '../base/guards.js';
import type { Ammo } from './ammo.js';
import { MANIFOLD, MANIFOLD_POINT as POINT } from './offsets.js';

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

/** Visits the pointers of its contact points. */
export function eachPoint(ammo: Ammo, manifold: number, visit: (point: number) => void): void {
  const count = ammo.HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
  for (let i = 0; i < count; i++) visit(pointAfter(manifold + MANIFOLD.points, i));
}

/** The solver's next step does not start from what went through its points in the last one. */
export function forgetImpulses(ammo: Ammo, manifold: number): void {
  const { HEAPF32 } = ammo;
  eachPoint(ammo, manifold, (point) => {
    for (const at of [POINT.impulse, POINT.lateralImpulse1, POINT.lateralImpulse2])
      HEAPF32[(point + at) >> 2] = guards.impulseOfOtherMass(HEAPF32[(point + at) >> 2]!);
  });
}
