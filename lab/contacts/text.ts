import { between } from '../draw/between.js';
import { markdownOf } from '../draw/table.js';
import type { Row } from '../run/row.js';
import type { ContactNumbers } from './numbers.js';
import { contactCosts, contactErrors } from './tables.js';

/** docs/contacts.md with the tables of these numbers. */
export const withContacts = (
  text: string,
  rows: readonly Row[],
  { costs }: ContactNumbers,
): string =>
  between(
    between(text, 'errors', markdownOf(contactErrors(rows))),
    'costs',
    markdownOf(contactCosts(costs)),
  );
