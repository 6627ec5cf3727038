// The chunk `contacts`.
import { ContactSolve } from './contact-solve/contact-solve.js';
import { contactSolve } from './contact-solve/effects.js';
import { ContactSurface } from './contacts/contact-surface.js';
import { contactSurface, givenContacts } from './contacts/effects.js';
import { GivenContacts } from './contacts/given-contacts.js';
import { ContinuousCollision } from './hits/continuous-collision.js';
import { continuousCollision, impactPropagation } from './hits/effects.js';
import { ImpactPropagation } from './hits/impact-propagation.js';
import { ContactShapes } from './manifolds/contact-shapes.js';
import { contactShapes } from './manifolds/effects.js';

export function provide(): void {
  contactShapes.load = (simulation, effects) => new ContactShapes(simulation, effects);
  contactSurface.load = (simulation) => new ContactSurface(simulation);
  givenContacts.load = (simulation, effects) => new GivenContacts(simulation, effects);
  contactSolve.load = (simulation, effects) => new ContactSolve(simulation, effects);
  continuousCollision.load = (simulation) => new ContinuousCollision(simulation);
  impactPropagation.load = (simulation, effects) => new ImpactPropagation(simulation, effects);
}
