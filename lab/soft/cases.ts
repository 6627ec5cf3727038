import { hangingCloth, drapes, net } from './cloths.js';
import type { SoftCase } from './case.js';
import { catenary, energy, heavyEnd, longRope, swing } from './ropes.js';

/** In the order of the tables. */
export const softCases: readonly SoftCase[] = [
  catenary,
  swing,
  energy,
  heavyEnd,
  longRope,
  hangingCloth,
  net,
  ...drapes,
];
