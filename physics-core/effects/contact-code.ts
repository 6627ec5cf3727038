// Effects of the chunk `contacts`.
import { ContactSolve } from './contact-solve/contact-solve.js';
import { contactSolve } from './contact-solve/effects.js';
import { touching } from './contact-solve/touching.js';
import { ContactReader } from './contacts/contact-reader.js';
import { contactReader, pairFilter } from './contacts/effects.js';
import { PairFilter } from './contacts/pair-filter.js';
import { ContactShapes } from './manifolds/contact-shapes.js';
import { contactShapes } from './manifolds/effects.js';

export function provideContactEffects(): void {
  contactShapes.load = (simulation, effects) => new ContactShapes(simulation, effects);
  contactSolve.found = touching;
  contactSolve.load = (simulation, effects) => new ContactSolve(simulation, effects);
  contactReader.load = (simulation, effects) => new ContactReader(simulation, effects);
  pairFilter.load = (simulation) => new PairFilter(simulation);
}
