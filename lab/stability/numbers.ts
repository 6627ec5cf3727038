import { readFileSync, writeFileSync } from 'node:fs';
import type { LevelName } from '../../physics-core/inside.js';
import type { Cell } from './case.js';
import { fromText, toText } from './json.js';

/** Of one case, by level. */
export type CellRow = Partial<Record<LevelName, Cell>>;

/** What one browser found. */
export interface BrowserNumbers {
  /** As it says itself. */
  version: string;
  date: string;
  /** By the ids of the cases. */
  cells: Record<string, CellRow>;
}

/** What the runs of the matrix found. */
export interface StabilityNumbers {
  machine: string;
  date: string;
  /** In Node, by the ids of the cases. */
  cells: Record<string, CellRow>;
  /** By the names of browsers. */
  browsers: Record<string, BrowserNumbers>;
  /** What other engines do, by the ids of cases and engines. */
  others: Record<string, Record<string, Cell>>;
}

export const FILE = new URL('../report/stability.json', import.meta.url);

export const readStability = (): StabilityNumbers =>
  fromText(readFileSync(FILE, 'utf8')) as StabilityNumbers;

export const writeStability = (numbers: StabilityNumbers): void =>
  writeFileSync(FILE, `${toText(numbers, 2)}\n`);
