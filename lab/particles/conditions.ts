import { loadavg } from 'node:os';
import { machine, MACHINE, today } from '../run/machine.js';
import { median, ninety } from '../statistics.js';
import type { Form } from './forms.js';
import type { Conditions, Spread } from './numbers.js';

/** How much is measured. */
export interface Pains {
  /** Particles of each system. */
  count: number;
  /** Turns of each side. */
  turns: number;
  /** Steps or frames of a turn. */
  each: number;
}

/** The same, and of what. */
export interface Plan extends Pains {
  /** Frames of a page before anything is measured. */
  warmUp: number;
  forms: readonly Form[];
}

export const conditions = (): Conditions => ({
  machine: MACHINE,
  date: today(),
  load: loadavg()[0]! / machine.cores,
});

export const spread = (values: readonly number[]): Spread => ({
  median: median(values),
  ninety: ninety(values),
});
