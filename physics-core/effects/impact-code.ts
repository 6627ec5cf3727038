// Effects of the chunk `impacts`.
import { ContactSurface } from './contacts/contact-surface.js';
import { contactSurface, givenContacts } from './contacts/effects.js';
import { GivenContacts } from './contacts/given-contacts.js';
import { Carrying } from './drag/carrying.js';
import { carrying } from './drag/effects.js';
import { ContinuousCollision } from './hits/continuous-collision.js';
import { continuousCollision, impactPropagation, sweptEnds } from './hits/effects.js';
import { ImpactPropagation } from './hits/impact-propagation.js';
import { SweptEnds } from './hits/swept-ends.js';

export function provideImpactEffects(): void {
  contactSurface.load = (simulation) => new ContactSurface(simulation);
  givenContacts.load = (simulation, effects) => new GivenContacts(simulation, effects);
  continuousCollision.load = (simulation) => new ContinuousCollision(simulation);
  sweptEnds.load = (simulation) => new SweptEnds(simulation);
  impactPropagation.load = (simulation, effects) => new ImpactPropagation(simulation, effects);
  carrying.load = (simulation, effects) => new Carrying(simulation, effects);
}
