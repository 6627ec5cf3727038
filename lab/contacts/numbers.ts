import { readFileSync, writeFileSync } from 'node:fs';
import type { ContactCost } from './cost.js';

/** What one run of the lab of contacts measured; the errors are cases of the report. */
export interface ContactNumbers {
  machine: string;
  date: string;
  costs: ContactCost[];
}

const FILE = new URL('../report/contacts.json', import.meta.url);

export const readContacts = (): ContactNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8')) as ContactNumbers;

export const writeContacts = (numbers: ContactNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, null, 2)}\n`);
