import { markdownOf } from '../draw/table.js';
import type { StabilityNumbers } from './numbers.js';
import { matrices, promiseCount } from './table.js';

const [BEGIN, END] = ['<!-- matrix -->', '<!-- end of matrix -->'];

/** docs/stability.md with the matrix of these numbers. */
export function withMatrix(text: string, numbers: StabilityNumbers): string {
  const { kept, broken } = promiseCount(numbers);
  const parts = [
    `${kept} promised cells hold${broken.length > 0 ? `; these break: ${broken.join(', ')}` : ', and none breaks'}. ${numbers.date}, ${numbers.machine}.`,
    ...matrices(numbers).map(([theme, table]) => `### ${theme}\n\n${markdownOf(table)}`),
  ];
  const from = text.indexOf(BEGIN) + BEGIN.length;
  return `${text.slice(0, from)}\n\n${parts.join('\n\n')}\n\n${text.slice(text.indexOf(END))}`;
}
