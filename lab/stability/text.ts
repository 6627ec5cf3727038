import { between } from '../draw/between.js';
import { markdownOf } from '../draw/table.js';
import { besidesNode, inBrowsers } from './browsers/table.js';
import type { StabilityNumbers } from './numbers.js';
import { besideOthers, dominoWaves, matrices } from './table.js';
import { verdictOf } from './verdict.js';

const matrixOf = (numbers: StabilityNumbers): string =>
  [
    `${numbers.date}, ${numbers.machine}.`,
    ...matrices(numbers).map(([theme, table]) => `### ${theme}\n\n${markdownOf(table)}`),
  ].join('\n\n');

/** Long, and for few: shown by a press. */
function browsersOf(numbers: StabilityNumbers): string {
  const others = besidesNode(numbers);
  const count = others.rows.length;
  const rest =
    count > 0
      ? `Those days were earlier than that of the matrix in Node, and the code has changed since: such cells come to other bits.\n\n<details><summary>The ${count} promised cells that come to other bits, and to what</summary>\n\n${markdownOf(others)}\n\n</details>`
      : 'All hold with the same bits.';
  return `${markdownOf(inBrowsers(numbers))}\n\n${rest}`;
}

/** docs/stability.md with the tables of these numbers. */
export const withMatrix = (text: string, numbers: StabilityNumbers): string =>
  [
    ['verdict', verdictOf(numbers)] as const,
    ['matrix', matrixOf(numbers)] as const,
    ['browsers', browsersOf(numbers)] as const,
    ['others', markdownOf(besideOthers(numbers))] as const,
    ['dominoes', markdownOf(dominoWaves(numbers))] as const,
  ].reduce((now, [name, content]) => between(now, name, content), text);
