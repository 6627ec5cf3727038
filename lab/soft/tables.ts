import { percent, quantity, threeDigits } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import type { Judged, SoftCase } from './case.js';
import { softCases } from './cases.js';
import { others } from './engines.js';
import { COMPARED, levelNames, nameOf } from './levels.js';
import {
  costOf,
  errorOf,
  frontierOf,
  oursAt,
  rowsOf,
  type SoftCell,
  type SoftNumbers,
  type SoftRow,
} from './numbers.js';

/** Everything that is judged and was measured. */
export const judgedIn = ({
  cells,
}: SoftNumbers): { which: SoftCase; judged: Judged; cell: SoftCell }[] =>
  softCases.flatMap((which) => {
    const cell = cells.find((one) => one.case === which.id);
    return cell ? which.judged.map((judged) => ({ which, judged, cell })) : [];
  });

const inWords = (off: number, unit: Judged['unit']): string =>
  unit === 'm' ? quantity(off, 'm') : percent(off);

/** Metres, or times the whole: what is further off flew apart. */
const APART = 100;

/** "< 1 µm" for what is below what rounding leaves. */
function shown(row: SoftRow | undefined, judged: Judged): string {
  if (!row) return '–';
  const off = errorOf(row, judged);
  if (off > APART) return 'flies apart, or sticks';
  if (off <= judged.floor) return `< ${inWords(judged.floor, judged.unit)}`;
  return inWords(off, judged.unit);
}

/** How far off ours is at each level. */
export const levelTable = (numbers: SoftNumbers): Table => ({
  head: ['off by', 'aim', ...levelNames.map((level) => `\`${level}\``)],
  rows: judgedIn(numbers).map(({ judged, cell }) => [
    judged.name,
    judged.aim ? inWords(judged.aim, judged.unit) : '–',
    ...levelNames.map((level) => shown(oursAt(cell, level), judged)),
  ]),
});

const spent = (row: SoftRow): string => `${threeDigits(costOf(row))} ms`;

/** What another comes to for no more than ours costs. */
function forAsMuch(cell: SoftCell, engine: string, judged: Judged, most: number): string {
  const best = frontierOf(rowsOf(cell, engine), judged)
    .filter((row) => costOf(row) <= most)
    .at(-1);
  return best ? `${shown(best, judged)} (${nameOf(best)})` : 'costs more';
}

/** What another takes to be as near. */
function forAsNear(cell: SoftCell, engine: string, judged: Judged, off: number): string {
  const frontier = frontierOf(rowsOf(cell, engine), judged);
  const first = frontier.find((row) => errorOf(row, judged) <= off);
  if (first) return `${spent(first)} (${nameOf(first)})`;
  const best = frontier.at(-1);
  return best ? `never; ${shown(best, judged)} for ${spent(best)}` : 'never';
}

/** Ours at one level, and the others for the same cost and for the same error. */
export const besideTable = (numbers: SoftNumbers): Table => ({
  head: [
    'off by',
    `ours, \`${COMPARED}\``,
    'a frame',
    ...others.flatMap(({ name }) => [`${name} for no more`, `${name} to be as near`]),
  ],
  rows: judgedIn(numbers).map(({ judged, cell }) => {
    const own = oursAt(cell)!;
    return [
      judged.name,
      shown(own, judged),
      spent(own),
      ...others.flatMap(({ id }) => [
        forAsMuch(cell, id, judged, costOf(own)),
        forAsNear(cell, id, judged, errorOf(own, judged)),
      ]),
    ];
  }),
});

/** What is judged in which another is as near as ours for no more, the others apart. */
export const asNear = (numbers: SoftNumbers, engine: string): string[] =>
  judgedIn(numbers)
    .filter(({ judged, cell }) => {
      const own = oursAt(cell)!;
      return rowsOf(cell, engine).some(
        (row) => costOf(row) <= costOf(own) && errorOf(row, judged) <= errorOf(own, judged),
      );
    })
    .map(({ judged }) => judged.name);

/** Milliseconds of a step. */
export const costTable = ({ cells }: SoftNumbers): Table => ({
  head: ['a step, ms', ...levelNames.map((level) => `\`${level}\``)],
  rows: cells.map((cell) => [
    softCases.find(({ id }) => id === cell.case)!.name,
    ...levelNames.map((level) => {
      const row = oursAt(cell, level);
      return row ? threeDigits(row.ms) : '–';
    }),
  ]),
});

/** Ours that misses its aim at that level. */
export const missed = (numbers: SoftNumbers): string[] =>
  judgedIn(numbers)
    .filter(({ judged, cell }) => judged.aim && errorOf(oursAt(cell)!, judged) > judged.aim)
    .map(({ judged, cell }) => `${judged.name}: ${shown(oursAt(cell), judged)}`);

/** Where a finer level is further off than the one before. */
export const worse = (numbers: SoftNumbers): string[] =>
  judgedIn(numbers).flatMap(({ judged, cell }) => {
    const rows = levelNames.flatMap((level) => oursAt(cell, level) ?? []);
    return rows
      .slice(1)
      .filter((row, i) => errorOf(row, judged) > errorOf(rows[i]!, judged))
      .map((row) => `${judged.name} at \`${row.level}\`: ${shown(row, judged)}`);
  });
