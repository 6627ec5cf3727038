import { between } from '../draw/between.js';
import { markdownOf } from '../draw/table.js';
import { readReport } from '../run/report.js';
import type { JointNumbers } from './numbers.js';
import { errorTable } from './tables.js';

/** The text with the table of these errors. */
export const withErrors = (text: string, { iterated }: JointNumbers): string =>
  between(text, 'errors', markdownOf(errorTable(readReport().rows, iterated)));
