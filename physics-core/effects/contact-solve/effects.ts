import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { ContactSolve } from './contact-solve.js';

export const contactSolve: EffectDescriptor<ContactSolve> = {
  name: 'contact solve',
  chunk: contacts,
  causes: 'bodies in touch',
  after: {
    'joint solve': 'its rows keep to what that has found',
    'contact surface': 'what contacts are like is written by then',
    'impact propagation': 'what hits is turned back by then',
  },
};
