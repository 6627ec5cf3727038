import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { ContactReader } from './contact-reader.js';
import type { ContactSurface } from './contact-surface.js';
import type { GivenContacts } from './given-contacts.js';
import type { PairFilter } from './pair-filter.js';

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

export const contactReader: EffectDescriptor<ContactReader> = {
  name: 'contact reading',
  chunk: contacts,
  causes: 'a CollisionSensor, or a listener to collisionstart or collisionend',
  after: { 'given contacts': 'they are put back as Bullet had them before they are read' },
};

export const pairFilter: EffectDescriptor<PairFilter> = {
  name: 'pair filter',
  chunk: contacts,
  causes: 'collidables that collide or not in a way that Bullet’s 15 group bits can’t tell',
};
