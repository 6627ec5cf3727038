import type { StabilityCase } from '../case.js';
import { chains } from './chains.js';
import { clocks } from './clocks.js';
import { edits } from './edits.js';
import { lettingGo } from './letting-go.js';
import { heaps } from './heaps.js';
import { mechanisms } from './mechanisms.js';
import { speeds } from './speeds.js';
import { soft } from './soft.js';
import { spins } from './spins.js';
import { loads, structures, towers } from './standing.js';
import { values } from './values.js';
import { waters } from './water.js';

/** The rows of the matrix, by theme. */
export const themes: Record<string, readonly StabilityCase[]> = {
  'Chains and nets': chains,
  Towers: towers,
  Loads: loads,
  Structures: structures,
  'Fast things': speeds,
  Spin: spins,
  Heaps: heaps,
  'Hard values': values,
  Clocks: clocks,
  Mechanisms: mechanisms,
  'Letting go': lettingGo,
  Water: waters,
  'Ropes and cloth': soft,
  Edits: edits,
};

export const stabilityCases: readonly StabilityCase[] = Object.values(themes).flat();
