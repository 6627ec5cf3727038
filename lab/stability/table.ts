import { levels, type LevelName } from '../../physics-core/inside.js';
import { quantity } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import type { Cell, StabilityCase } from './case.js';
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
    : `breaks: ${why ?? (Number.isNaN(measured) ? 'no number' : number)}`;
}

/** In a table: what is promised stands in bold. */
function cellOf(which: StabilityCase, row: CellRow | undefined, level: LevelName): string {
  const cell = row?.[level];
  if (!cell) return '–';
  const words = wordsOf(which, cell);
  return promises(which, level) ? `**${words}**` : words;
}

/** A theme's rows: levels across, cases down. */
const matrixOf = (theme: string, { cells }: StabilityNumbers): Table => ({
  head: ['id', 'case', ...levelNames, 'criterion', 'load'],
  rows: themes[theme]!.map((which) => [
    which.id,
    which.says,
    ...levelNames.map((level) => cellOf(which, cells[which.id], level)),
    criterionOf(which),
    loadOf(which),
  ]),
});

/** The cases that other engines can be told, with steps of 1/120 s in all of them. */
export const besideOthers = ({ cells, others }: StabilityNumbers): Table => ({
  head: ['id', 'case', 'ours', ...OTHERS.map(([, name]) => name)],
  rows: stabilityCases
    .filter(({ id }) => others[id])
    .map((which) => [
      which.id,
      which.says,
      cells[which.id]?.standard ? wordsOf(which, cells[which.id]!.standard!) : '–',
      ...OTHERS.map(([{ id }]) => {
        const cell = others[which.id]?.[id];
        return cell ? wordsOf(which, cell) : '–';
      }),
    ]),
});

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
