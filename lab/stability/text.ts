import { between } from '../draw/between.js';
import { markdownOf } from '../draw/table.js';
import { besidesNode, inBrowsers } from './browsers/table.js';
import type { StabilityNumbers } from './numbers.js';
import { besideOthers, dominoWaves, matrices, promiseCount } from './table.js';

function matrixOf(numbers: StabilityNumbers): string {
  const { kept, broken } = promiseCount(numbers);
  const breaks = broken.length > 0 ? `; these break: ${broken.join(', ')}` : ', and none breaks';
  return [
    `${kept} promised cells hold${breaks}. ${numbers.date}, ${numbers.machine}.`,
    ...matrices(numbers).map(([theme, table]) => `### ${theme}\n\n${markdownOf(table)}`),
  ].join('\n\n');
}

function browsersOf(numbers: StabilityNumbers): string {
  const other = besidesNode(numbers).map((words) => `- ${words}`);
  const rest =
    other.length > 0 ? `Those that do not:\n\n${other.join('\n')}` : 'All hold with the same bits.';
  return `${markdownOf(inBrowsers(numbers))}\n\n${rest}`;
}

/** docs/stability.md with the tables of these numbers. */
export const withMatrix = (text: string, numbers: StabilityNumbers): string =>
  [
    ['matrix', matrixOf(numbers)] as const,
    ['browsers', browsersOf(numbers)] as const,
    ['others', markdownOf(besideOthers(numbers))] as const,
    ['dominoes', markdownOf(dominoWaves(numbers))] as const,
  ].reduce((now, [name, content]) => between(now, name, content), text);
