import { readFileSync, writeFileSync } from 'node:fs';
import { softCases } from './cases.js';
import type { SoftSetting } from './engine.js';
import { COMPARED } from './levels.js';

/** One library at one setting. */
export interface SoftRow extends SoftSetting {
  engine: string;
  /** Of a step. */
  ms: number;
  /** By what is judged; null where it flew apart or stuck. */
  errors: Record<string, number | null>;
}

/** One scene, and where and when it was measured; `load`: processes that wanted to run on each core. */
export interface SoftCell {
  case: string;
  machine: string;
  date: string;
  load: number;
  rows: SoftRow[];
}

export interface SoftNumbers {
  /** Of the packages beside ours. */
  versions: Record<string, string>;
  cells: SoftCell[];
}

const FILE = new URL('../report/soft.json', import.meta.url);

export const readSoft = (): SoftNumbers => JSON.parse(readFileSync(FILE, 'utf8')) as SoftNumbers;

/** Times and errors are not known better. */
const rounded = (_: string, value: unknown): unknown =>
  typeof value === 'number' ? Number(value.toPrecision(4)) : value;

/** A row per line, so that a new run shows what changed. */
export function writeSoft({ versions, cells }: SoftNumbers): void {
  const lines = cells.map(({ rows, ...rest }) => {
    const head = JSON.stringify(rest, rounded).slice(0, -1);
    return `${head},"rows":[\n${rows.map((row) => JSON.stringify(row, rounded)).join(',\n')}\n]}`;
  });
  writeFileSync(
    FILE,
    `{"versions":${JSON.stringify(versions)},"cells":[\n${lines.join(',\n')}\n]}\n`,
  );
}

const placeOf = ({ case: id }: SoftCell): number => softCases.findIndex((one) => one.id === id);

/** With a scene measured anew in its place, and without those that are no more. */
export const withCell = (cells: readonly SoftCell[], fresh: SoftCell): SoftCell[] =>
  [...cells.filter((cell) => cell.case !== fresh.case), fresh]
    .filter((cell) => placeOf(cell) >= 0)
    .sort((a, b) => placeOf(a) - placeOf(b));

/** Seconds of a frame, by which costs are compared: steps are of different lengths. */
const FRAME = 1 / 60;

/** Milliseconds for a frame of a sixtieth of a second. */
export const costOf = ({ ms, step }: SoftRow): number => (ms * FRAME) / step;

export const rowsOf = ({ rows }: SoftCell, engine: string): SoftRow[] =>
  rows.filter((row) => row.engine === engine);

export const oursAt = (cell: SoftCell, level = COMPARED): SoftRow | undefined =>
  cell.rows.find((row) => row.level === level);

/** What flew apart is infinitely off; what is below what rounding leaves is as good as that. */
export const errorOf = (
  { errors }: SoftRow,
  { id, floor }: { id: string; floor: number },
): number => Math.max(floor, errors[id] ?? Infinity);

/** Of those, the ones than which none is both cheaper and better, from cheap to dear. */
export function frontierOf(
  rows: readonly SoftRow[],
  judged: { id: string; floor: number },
): SoftRow[] {
  let best = Infinity;
  return rows
    .toSorted((a, b) => costOf(a) - costOf(b))
    .filter((row) => {
      const off = errorOf(row, judged);
      if (off >= best) return false;
      best = off;
      return true;
    });
}
