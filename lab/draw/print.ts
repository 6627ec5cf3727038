import type { Case } from '../case.js';
import { floorOf } from '../case.js';
import type { Measured, Row } from '../run/row.js';
import { brokenRungs } from './judge.js';
import { milliseconds, quantity, stepOf } from './numbers.js';
import { columnsOf } from './table.js';

const cells = (row: Row): string[] => [
  row.engine,
  row.level ?? '',
  stepOf(row.step),
  String(row.iterations),
  quantity(row.error, row.unit),
  quantity(row.gap, 'm'),
  milliseconds(row.ms),
];

function caseText(which: Case, { rows, notOffered }: Measured): string {
  const of = <T extends { case: string }>(list: T[]) => list.filter((one) => one.case === which.id);
  const broken = brokenRungs(which, rows);
  return [
    `\n${which.id}, ${which.name}: ${which.says} Floor ${quantity(floorOf(which), which.unit)}.`,
    columnsOf([
      ['engine', 'level', 'step', 'iterations', 'error', 'gap', 'per second'],
      ...of(rows).map(cells),
    ]),
    ...of(notOffered).map(({ engine, reason }) => `${engine} does not offer ${reason}`),
    ...(broken.length > 0 ? [`worse than the level before: ${broken.join(', ')}`] : []),
  ].join('\n');
}

/** What was measured, as text. */
export const printed = (cases: readonly Case[], results: Measured): string =>
  cases.map((which) => caseText(which, results)).join('\n');
