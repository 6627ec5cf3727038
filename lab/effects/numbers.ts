import { readFileSync, writeFileSync } from 'node:fs';
import type { EffectCost } from './measure.js';

/** What one run found each effect to add. */
export interface EffectNumbers {
  machine: string;
  date: string;
  bodies: number;
  /** Pairs of turns, and steps of a turn. */
  pairs: number;
  turn: number;
  costs: (EffectCost & { bytes: number })[];
}

const FILE = new URL('../report/effects.json', import.meta.url);

export const readEffects = (): EffectNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8')) as EffectNumbers;

export const writeEffects = (numbers: EffectNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, null, 2)}\n`);
