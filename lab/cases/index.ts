import type { Case } from '../case.js';
import { cases as bounce } from './bounce.js';
import { cases as carried } from './carried.js';
import { cases as chains } from './chains.js';
import { cases as cradle } from './cradle.js';
import { cases as flight } from './flight.js';
import { cases as hits } from './hits.js';
import { cases as leaning } from './leaning.js';
import { cases as linkages } from './linkages.js';
import { cases as machines } from './machines.js';
import { cases as pendulums } from './pendulums.js';
import { cases as rolling } from './rolling.js';
import { cases as rubbing } from './rubbing.js';
import { cases as sliding } from './sliding.js';
import { cases as slipping } from './slipping.js';
import { cases as spinningHits } from './spinning-hits.js';
import { cases as springs } from './springs.js';
import { cases as standing } from './standing.js';
import { cases as tipping } from './tipping.js';
import { cases as tops } from './tops.js';
import { cases as turntable } from './turntable.js';
import { cases as upright } from './upright.js';

/** Every case of the lab: what flies, what touches, what stands, what hangs together. */
export const cases: readonly Case[] = [
  ...flight,
  ...bounce,
  ...sliding,
  ...slipping,
  ...leaning,
  ...tipping,
  ...rubbing,
  ...rolling,
  ...turntable,
  ...tops,
  ...hits,
  ...spinningHits,
  ...standing,
  ...carried,
  ...pendulums,
  ...upright,
  ...chains,
  ...cradle,
  ...machines,
  ...springs,
  ...linkages,
];

/** Those of this name, or of this family: `chain` stands for all of `chain-*`. */
export function casesNamed(name: string): readonly Case[] {
  const exact = cases.filter(({ id }) => id === name);
  return exact.length > 0 ? exact : cases.filter(({ id }) => id.startsWith(`${name}-`));
}

export function caseOf(id: string): Case {
  const found = cases.find((one) => one.id === id);
  if (!found) throw new Error(`there is no case ${id}`);
  return found;
}
