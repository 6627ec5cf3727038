import type { Simulation } from '../../dynamics/simulation.js';
import { pointCountAt } from '../../engine/manifold.js';
import { inverseMassOf } from '../../engine/solver-body.js';
import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import type { ContactSolve } from './contact-solve.js';

/** Looked at in every step in which Bullet has found what may be in touch. */
function touching(simulation: Simulation, effects: Effects): void {
  if (!simulation.bullet.settings.direct || effects.caused(contactSolve)) return;
  const { ammo } = simulation.engine;
  simulation.bullet.eachAwakeManifold((manifold, a, b) => {
    if (pointCountAt(ammo, manifold) === 0) return;
    const body = simulation.bodyAt(inverseMassOf(ammo, a) === 0 ? b : a);
    if (body) effects.get(contactSolve).touch(body);
  });
}

export const contactSolve: EffectDescriptor<ContactSolve> = {
  name: 'contact solve',
  chunk: contacts,
  causes: 'bodies in touch',
  after: {
    'joint solve': 'its rows keep to what that has found',
    'contact surface': 'what contacts are like is written by then',
    'impact propagation': 'what hits is turned back by then',
  },
  found: touching,
};
