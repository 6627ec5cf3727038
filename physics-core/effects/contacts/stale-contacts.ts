import { speedBetween } from '../../engine/body-heap.js';
import { breakingAt, forgetPoints } from '../../engine/manifold-points.js';
import type { Simulation } from '../../dynamics/simulation.js';

/** Share of the way that a contact point lives for, in a step. */
const LONG = 0.5;

/** Ways in a step that are short for anything, metres. */
const SHORT = 0.005;

/** Whether any body moves so far in a step that contact points may not keep up. */
export const anyFast = ({ bodies }: Simulation, dt: number): boolean =>
  bodies.anyFaster(SHORT / dt);

/**
 * Visits pairs near each other that move farther along each other in a step than their contact points live for. `touchingOnly`:
 * those that have any.
 */
export function eachFastPair(
  { bullet, engine: { ammo } }: Simulation,
  dt: number,
  visit: (manifold: number, a: number, b: number) => void,
  touchingOnly = false,
): void {
  const see = (manifold: number, a: number, b: number): void => {
    if (speedBetween(ammo, a, b) * dt > LONG * breakingAt(ammo, manifold)) visit(manifold, a, b);
  };
  bullet.eachPair(see, false, touchingOnly);
}

/**
 * Bullet keeps contact points from step to step, to start its solver from. What slides or rolls on farther than they live
 * for leaves them behind: they take up the room of new ones, and rub where nothing touches any more (measured: a tenth of
 * a ball's friction, and blocks that stand on two of their corners).
 */
export function forgetStale(simulation: Simulation, dt: number): void {
  const { ammo } = simulation.engine;
  eachFastPair(simulation, dt, (manifold) => forgetPoints(ammo, manifold), true);
}
