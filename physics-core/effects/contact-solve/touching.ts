import type { Simulation } from '../../dynamics/simulation.js';
import { inverseMassOf } from '../../engine/body-state.js';
import type { Effects } from '../effect/effects.js';
import { contactSolve } from './effects.js';

/** Looked at in every step in which Bullet has found what may be in touch. */
export function touching(simulation: Simulation, effects: Effects): void {
  if (!simulation.bullet.settings.direct || effects.caused(contactSolve)) return;
  const { ammo } = simulation.engine;
  simulation.bullet.eachAwakeTouching((_, a, b) => {
    const body = simulation.bodyAt(inverseMassOf(ammo, a) === 0 ? b : a);
    if (body) effects.get(contactSolve).touch(body);
  });
}
