import { levels, type LevelName } from '../../physics-core/inside.js';
import { dominoSpeed } from '../../references/domino-wave.js';
import { quantity, threeDigits } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import type { Cell, StabilityCase } from './case.js';
import { dominoes, ROW } from './cases/dominoes.js';
import { stabilityCases, themes } from './cases/index.js';
import { promises } from './levels.js';
import type { CellRow, StabilityNumbers } from './numbers.js';
import { OTHERS } from './others.js';

const levelNames: readonly LevelName[] = levels.map(({ name }) => name);

export const criterionOf = ({ criterion: { what, most, unit } }: StabilityCase): string =>
  `${what} ≤ ${quantity(most, unit).trim()}`;

export const loadOf = ({ load }: StabilityCase): string =>
  load ? `${load.of} ${load.ratio.toLocaleString('en')}` : '–';

/** What a cell says: the number, or what broke. */
export function wordsOf({ criterion }: StabilityCase, { holds, measured, why }: Cell): string {
  const number = quantity(measured, criterion.unit).trim();
  return holds
    ? `holds ${number}`
    : `breaks: ${why ?? (Number.isFinite(measured) ? number : 'no number')}`;
}

/** The same in a narrow column. */
export function signOf({ criterion }: StabilityCase, cell: Cell | undefined): string {
  if (!cell) return '–';
  const { holds, measured, why } = cell;
  const number = Number.isFinite(measured)
    ? quantity(measured, criterion.unit).trim()
    : 'no number';
  return holds ? `✓ ${number}` : `✗ ${why ?? number}`;
}

/** In a table: what is promised stands in bold. */
function cellOf(which: StabilityCase, row: CellRow | undefined, level: LevelName): string {
  const cell = row?.[level];
  const sign = signOf(which, cell);
  return cell && promises(which, level) ? `**${sign}**` : sign;
}

/** Case, criterion and load in one column, so that the numbers beside it have room. */
function wholeCase(which: StabilityCase): string {
  const load = which.load ? `; ${loadOf(which)}` : '';
  return `**${which.id}** ${which.says}<br>*${criterionOf(which)}${load}*`;
}

/** A theme's rows: levels across, cases down. */
const matrixOf = (theme: string, { cells }: StabilityNumbers): Table => ({
  head: ['case', ...levelNames],
  rows: themes[theme]!.map((which) => [
    wholeCase(which),
    ...levelNames.map((level) => cellOf(which, cells[which.id], level)),
  ]),
});

/** The cases that other engines can be told, with steps of 1/120 s in all of them. */
export const besideOthers = ({ cells, others }: StabilityNumbers): Table => ({
  head: ['case', 'ours', ...OTHERS.map(({ name }) => name)],
  rows: stabilityCases
    .filter(({ id }) => others[id])
    .map((which) => [
      `${which.says}; ${criterionOf(which)}`,
      signOf(which, cells[which.id]?.standard),
      ...OTHERS.map(({ engine }) => signOf(which, others[which.id]?.[engine.id])),
    ]),
});

const named = (name: string, { noted, measured }: Cell): string[] => {
  const { speed = NaN } = noted ?? {};
  return [name, speed ? `${threeDigits(speed)} m/s` : '–', quantity(measured, '').trim()];
};

/** How fast the wave of dominoes is, and how uneven. */
export function dominoWaves({ cells, others }: StabilityNumbers): Table {
  const ours = levelNames.flatMap((level) => {
    const cell = cells[dominoes.id]?.[level];
    return cell ? [named(`ours, ${level}`, cell)] : [];
  });
  const theirs = OTHERS.flatMap(({ engine, name }) => {
    const cell = others[dominoes.id]?.[engine.id];
    return cell ? [named(name, cell)] : [];
  });
  const truth = ['van Leeuwen 2010', `${threeDigits(dominoSpeed(ROW))} m/s`, '0'];
  return { head: ['', 'speed of the wave', 'unevenness'], rows: [truth, ...ours, ...theirs] };
}

export const matrices = (numbers: StabilityNumbers): [theme: string, table: Table][] =>
  Object.keys(themes).map((theme) => [theme, matrixOf(theme, numbers)]);

/** Promised cells, of those that were looked at, and which of them break. */
export function promiseCount({ cells }: StabilityNumbers): { kept: number; broken: string[] } {
  const all = Object.values(themes)
    .flat()
    .flatMap((which) =>
      levelNames.flatMap((level) => {
        const cell = cells[which.id]?.[level];
        return cell && promises(which, level) ? [{ name: `${which.id} at ${level}`, cell }] : [];
      }),
    );
  const broken = all.filter(({ cell }) => !cell.holds).map(({ name }) => name);
  return { kept: all.length - broken.length, broken };
}
