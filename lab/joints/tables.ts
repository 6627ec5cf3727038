import { errorOf, levelNames } from '../draw/judge.js';
import { milliseconds, percent, quantity, threeDigits } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import type { Row } from '../run/row.js';
import type { Cost } from './cost.js';
import type { Endurance } from './endurance.js';
import { chains } from './errors.js';

/** Errors of chains at each level with the solve and without, and the milliseconds per simulated second in brackets. */
export function errorTable(solved: readonly Row[], iterated: readonly Row[]): Table {
  const cell = (id: string, level: string, rows: readonly Row[]): string => {
    const row = rows.find((one) => one.case === id && one.level === level)!;
    return `${quantity(errorOf(row), 'm')} (${milliseconds(row.ms)})`;
  };
  return {
    head: ['level', ...chains.flatMap(({ name }) => [`${name}, solve`, `${name}, without`])],
    rows: levelNames.map((level) => [
      level,
      ...chains.flatMap(({ id }) => [solved, iterated].map((rows) => cell(id, level, rows))),
    ]),
  };
}

export const enduranceTable = (rows: readonly Endurance[]): Table => ({
  head: ['scene', 'level', 'solve', 'seconds', 'widest gap, of a link', 'all gaps, of the length'],
  rows: rows.map(({ scene, level, solve, seconds, widest, sum }) => [
    scene,
    level,
    solve,
    String(seconds),
    percent(widest),
    percent(sum),
  ]),
});

export const costTable = (rows: readonly Cost[]): Table => ({
  head: ['shape', 'level', 'joints', 'solve, µs', 'Bullet, µs', 'ratio', 'whole step'],
  rows: rows.map(({ shape, level, joints, solve, bullet, ratio, total }) => [
    shape,
    level,
    String(joints),
    ...[solve, bullet, ratio, total].map(threeDigits),
  ]),
});
