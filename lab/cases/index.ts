import type { Case } from '../case.js';
import { cases as bounce } from './bounce.js';
import { cases as chains } from './chains.js';
import { cases as flight } from './flight.js';
import { cases as hits } from './hits.js';
import { cases as linkages } from './linkages.js';
import { cases as machines } from './machines.js';
import { cases as pendulums } from './pendulums.js';
import { cases as rolling } from './rolling.js';
import { cases as sliding } from './sliding.js';
import { cases as springs } from './springs.js';

/** Every case of the lab, by its number. */
export const cases: readonly Case[] = [
  ...bounce,
  ...chains,
  ...flight,
  ...hits,
  ...linkages,
  ...machines,
  ...pendulums,
  ...rolling,
  ...sliding,
  ...springs,
].sort((a: Case, b: Case) => a.id.localeCompare(b.id, 'en', { numeric: true }));
