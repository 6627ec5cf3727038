import { markdownOf } from '../draw/table.js';
import type { StabilityNumbers } from './numbers.js';
import { besideOthers, matrices, promiseCount } from './table.js';

/** The text with something else between the two marks of that name. */
function between(text: string, name: string, content: string): string {
  const [begin, end] = [`<!-- ${name} -->`, `<!-- end of ${name} -->`];
  const from = text.indexOf(begin) + begin.length;
  return `${text.slice(0, from)}\n\n${content}\n\n${text.slice(text.indexOf(end))}`;
}

function matrixOf(numbers: StabilityNumbers): string {
  const { kept, broken } = promiseCount(numbers);
  const breaks = broken.length > 0 ? `; these break: ${broken.join(', ')}` : ', and none breaks';
  return [
    `${kept} promised cells hold${breaks}. ${numbers.date}, ${numbers.machine}.`,
    ...matrices(numbers).map(([theme, table]) => `### ${theme}\n\n${markdownOf(table)}`),
  ].join('\n\n');
}

/** docs/stability.md with the tables of these numbers. */
export const withMatrix = (text: string, numbers: StabilityNumbers): string =>
  between(between(text, 'matrix', matrixOf(numbers)), 'others', markdownOf(besideOthers(numbers)));
