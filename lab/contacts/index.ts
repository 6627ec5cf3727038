// npm run lab -- contacts: what the direct solve of contacts costs. Writes lab/report/contacts.json, draws the page of the
// report beside it and puts both tables into docs/contacts.md. The errors are those of the report's cases.
//   --draw   measure nothing: page and tables of the numbers of last time
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { drawPages, readBeside } from '../draw/report.js';
import { columnsOf, type Table } from '../draw/table.js';
import { MACHINE, today } from '../run/machine.js';
import { readReport } from '../run/report.js';
import { costs } from './cost.js';
import { readContacts, writeContacts } from './numbers.js';
import { contactCosts, contactErrors } from './tables.js';
import { withContacts } from './text.js';

const { values: options } = parseArgs({ options: { draw: { type: 'boolean', default: false } } });

const TEXT = new URL('../../docs/contacts.md', import.meta.url);

const print = ({ head, rows }: Table): void => console.log(`\n${columnsOf([head, ...rows], 1)}`);

if (!options.draw) writeContacts({ machine: MACHINE, date: today(), costs: await costs() });
const numbers = readContacts();
const report = readReport();
print(contactErrors(report.rows));
print(contactCosts(numbers.costs));
writeFileSync(TEXT, withContacts(readFileSync(TEXT, 'utf8'), report.rows, numbers));
drawPages(report, { ...readBeside(), contacts: numbers });
