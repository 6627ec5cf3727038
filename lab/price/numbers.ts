import { readFileSync, writeFileSync } from 'node:fs';
import { levelNames } from './engines.js';
import type { PriceCell } from './measure.js';
import { priceScenes } from './scenes/index.js';

/** What all runs found, by scenes and levels in their order. */
export interface PriceNumbers {
  cells: PriceCell[];
}

const FILE = new URL('../report/price.json', import.meta.url);

export const readPrice = (): PriceNumbers => JSON.parse(readFileSync(FILE, 'utf8')) as PriceNumbers;

/** Times and errors are not known better. */
const rounded = (_: string, value: unknown): unknown =>
  typeof value === 'number' ? Number(value.toPrecision(4)) : value;

/** One cell per line, so that a new run shows what changed. */
export function writePrice({ cells }: PriceNumbers): void {
  const lines = cells.map((cell) => JSON.stringify(cell, rounded)).join(',\n');
  writeFileSync(FILE, `{"cells":[\n${lines}\n]}\n`);
}

const placeOf = ({ scene, level }: PriceCell): number =>
  priceScenes.findIndex(({ id }) => id === scene) * levelNames.length + levelNames.indexOf(level);

/** With a cell measured anew in its place. */
export const withCell = ({ cells }: PriceNumbers, fresh: PriceCell): PriceNumbers => ({
  cells: [...cells.filter((cell) => placeOf(cell) !== placeOf(fresh)), fresh].sort(
    (a, b) => placeOf(a) - placeOf(b),
  ),
});

export const cellOf = (
  { cells }: PriceNumbers,
  scene: string,
  level: string,
): PriceCell | undefined => cells.find((cell) => cell.scene === scene && cell.level === level);
