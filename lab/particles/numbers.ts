import { readFileSync, writeFileSync } from 'node:fs';
import type { Estimate } from '../statistics.js';

/** Milliseconds. */
export interface Spread {
  median: number;
  /** What 9 of 10 do not exceed. */
  ninety: number;
}

/** Where, when and how busy that was: processes that wanted to run on each core in the minute before it ended. */
export interface Conditions {
  machine: string;
  date: string;
  load: number;
}

/** What a step costs in Node. */
export interface NodeRow {
  scene: string;
  living: number;
  /** Of the whole step, by sides. */
  sides: Record<string, Spread>;
  /** What particles add to a step of the bodies alone. */
  added?: Spread;
  /** Our step to that of Babylon.js, turn by turn. */
  toBabylon?: Estimate;
}

/** Script of a frame in a page. */
export interface PageSide {
  script: Spread;
  step: Spread;
  drawing: Spread;
  /** How many lived at the end, and how high they were on average, metres, where the library knows. */
  living: number | null;
  height: number | null;
  /** Our script to this one's, turn by turn. */
  ours?: Estimate;
}

export interface PageRow {
  form: string;
  /** What could not be measured says why. */
  sides: Record<string, PageSide | string>;
}

export interface ParticleNumbers {
  /** Of what draws each library's pages. */
  versions: Record<string, string>;
  /** Particles of each system. */
  count: number;
  /** Turns of each side, and steps or frames of each turn. */
  turns: number;
  each: number;
  node: Conditions & { rows: NodeRow[] };
  chromium: Conditions & { version: string; rows: PageRow[] };
}

const FILE = new URL('../report/particles.json', import.meta.url);

export const readParticles = (): ParticleNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8')) as ParticleNumbers;

/** Times are not known better. */
const rounded = (_: string, value: unknown): unknown =>
  typeof value === 'number' ? Number(value.toPrecision(4)) : value;

export const writeParticles = (numbers: ParticleNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, rounded, 1)}\n`);
