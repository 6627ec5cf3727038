import { readFileSync, writeFileSync } from 'node:fs';
import type { LevelName } from '../../physics-core/inside.js';
import type { Cell } from './case.js';

/** Of one case, by level. */
export type CellRow = Partial<Record<LevelName, Cell>>;

/** What the runs of the matrix found. */
export interface StabilityNumbers {
  machine: string;
  date: string;
  /** By the ids of the cases. */
  cells: Record<string, CellRow>;
  /** What other engines do, by the ids of cases and engines. */
  others: Record<string, Record<string, Cell>>;
}

export const FILE = new URL('../report/stability.json', import.meta.url);

/** JSON has no word for it: a NaN would come back as null. */
const NO_NUMBER = 'NaN';

export const readStability = (): StabilityNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8'), (_, value: unknown) =>
    value === NO_NUMBER ? NaN : value,
  ) as StabilityNumbers;

export const writeStability = (numbers: StabilityNumbers): void =>
  writeFileSync(
    FILE,
    `${JSON.stringify(numbers, (_, value: unknown) => (Number.isNaN(value) ? NO_NUMBER : value), 2)}\n`,
  );
