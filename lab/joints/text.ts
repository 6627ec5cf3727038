import { markdownOf } from '../draw/table.js';
import { readReport } from '../run/report.js';
import type { JointNumbers } from './numbers.js';
import { errorTable } from './tables.js';

const MARKS = ['<!-- errors -->', '<!-- end of errors -->'] as const;

/** The text with the table of these errors between its two marks. */
export function withErrors(text: string, { iterated }: JointNumbers): string {
  const [from, to] = MARKS.map((mark) => text.indexOf(mark)) as [number, number];
  const table = markdownOf(errorTable(readReport().rows, iterated));
  return `${text.slice(0, from + MARKS[0].length)}\n\n${table}\n\n${text.slice(to)}`;
}
