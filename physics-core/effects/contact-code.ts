// Effects of the chunk `contacts`.
import { ContactSolve } from './contact-solve/contact-solve.js';
import { contactSolve } from './contact-solve/effects.js';
import { touching } from './contact-solve/touching.js';
import { ContactReader } from './contacts/contact-reader.js';
import { ContactSurface } from './contacts/contact-surface.js';
import { contactReader, contactSurface, givenContacts, pairFilter } from './contacts/effects.js';
import { GivenContacts } from './contacts/given-contacts.js';
import { PairFilter } from './contacts/pair-filter.js';
import { Carrying } from './drag/carrying.js';
import { carrying } from './drag/effects.js';
import { ContinuousCollision } from './hits/continuous-collision.js';
import { continuousCollision, impactPropagation, sweptEnds } from './hits/effects.js';
import { ImpactPropagation } from './hits/impact-propagation.js';
import { SweptEnds } from './hits/swept-ends.js';
import { ContactShapes } from './manifolds/contact-shapes.js';
import { contactShapes } from './manifolds/effects.js';

export function provideContactEffects(): void {
  contactShapes.load = (simulation, effects) => new ContactShapes(simulation, effects);
  contactSurface.load = (simulation) => new ContactSurface(simulation);
  givenContacts.load = (simulation, effects) => new GivenContacts(simulation, effects);
  contactSolve.found = touching;
  contactSolve.load = (simulation, effects) => new ContactSolve(simulation, effects);
  continuousCollision.load = (simulation) => new ContinuousCollision(simulation);
  sweptEnds.load = (simulation) => new SweptEnds(simulation);
  impactPropagation.load = (simulation, effects) => new ImpactPropagation(simulation, effects);
  carrying.load = (simulation, effects) => new Carrying(simulation, effects);
  contactReader.load = (simulation, effects) => new ContactReader(simulation, effects);
  pairFilter.load = (simulation) => new PairFilter(simulation);
}
