import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { ContactSurface } from './contact-surface.js';
import type { GivenContacts } from './given-contacts.js';

export const contactSurface: EffectDescriptor<ContactSurface> = {
  name: 'contact surface',
  chunk: contacts,
  causes:
    'a CollisionCollection that says more than the default, maxCorrectionSpeed, or set_contacts',
  after: { 'joint solve': 'it notes velocities as Bullet gets them' },
};

export const givenContacts: EffectDescriptor<GivenContacts> = {
  name: 'given contacts',
  chunk: contacts,
  causes: 'set_contacts of a RigidBodyCollection',
  after: {
    'joint solve': 'what page code adds acts on the velocities that joints leave',
    'contact surface': 'its step is summed up before the lists go',
  },
};
