import { markdownOf, type Table } from '../draw/table.js';
import type { Row } from '../run/row.js';
import type { ContactNumbers } from './numbers.js';
import { contactCosts, contactErrors } from './tables.js';

/** The text with a table between the two marks of that name. */
function withTable(text: string, name: string, table: Table): string {
  const [begin, end] = [`<!-- ${name} -->`, `<!-- end of ${name} -->`];
  const from = text.indexOf(begin) + begin.length;
  return `${text.slice(0, from)}\n\n${markdownOf(table)}\n\n${text.slice(text.indexOf(end))}`;
}

/** docs/contacts.md with the tables of these numbers. */
export const withContacts = (
  text: string,
  rows: readonly Row[],
  { costs }: ContactNumbers,
): string =>
  withTable(withTable(text, 'errors', contactErrors(rows)), 'costs', contactCosts(costs));
