import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Effects } from '../effect/effects.js';
import { resting } from './resting.js';

/**
 * Wakes what touches a body that goes or jumps, or hangs on it: it may have lost its support. What is awake has nobody
 * asleep around it, and what sleeps fell asleep with all that touches it, so that an edit of either looks at no contact.
 */
export function wakeTouching(simulation: Simulation, effects: Effects, body: Body): void {
  const { slot, isDynamic, joints } = body;
  // One that is being taken down calls itself neither active nor asleep any more.
  if (isDynamic && simulation.bodies.moving.asleep[slot] !== 1) return;
  const rest = effects.find(resting);
  const island = isDynamic ? rest?.islandOf(slot) : undefined;
  if (island) {
    for (const other of island) if (other !== body) other.wake();
    return;
  }
  for (const { attached, body1, body2 } of joints)
    if (attached) for (const end of [body1, body2]) end?.wake();
  simulation.bullet.eachTouching(body.pointer, (other) => simulation.bodyAt(other)?.wake());
}
