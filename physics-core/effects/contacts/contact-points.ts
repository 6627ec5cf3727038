import type { Ammo } from '../../engine/ammo.js';
import { pairTestOf } from '../../engine/pair-test.js';
import { pointAfter } from '../../engine/manifold.js';
import { solverDistanceAt } from '../../engine/manifold-points.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';

/** Up to this distance a sensor has two bodies touch, metres: a resting sphere has 1.5e-16 in some steps. */
export const TOUCHING = 0.0005;

/** What the pair filter has taken back lies at 1e30 m. */
const FILTERED = 9e29;

/** Whether the pair filter has taken a point back: its collidables do not collide. */
export const isFiltered = (ammo: Ammo, pointer: number): boolean =>
  solverDistanceAt(ammo, pointer) >= FILTERED;

/** Every contact point that the pair filter left in, and what hit at the very end of the step, by its pointer. */
export function eachContactPoint(
  simulation: Simulation,
  visit: (pointer: number, a: Body, b: Body) => void,
): void {
  const { engine, bullet } = simulation;
  const { ammo } = engine;
  pairTestOf(engine).each(bullet.bullet, (pointer, pointerA, pointerB) => {
    const a = simulation.bodyAt(pointerA);
    const b = simulation.bodyAt(pointerB);
    if (a && b && !isFiltered(ammo, pointer)) visit(pointer, a, b);
  });
  bullet.eachTouchingPair((first, count, pointerA, pointerB) => {
    const a = simulation.bodyAt(pointerA);
    const b = a && simulation.bodyAt(pointerB);
    if (!a || !b) return;
    for (let i = 0; i < count; i++) {
      const pointer = pointAfter(first, i);
      if (!isFiltered(ammo, pointer)) visit(pointer, a, b);
    }
  });
}
