// npm run lab -- joints: what the direct solve of joints gains and costs. Writes lab/report/joints.json, draws the page of
// the report beside it and puts the table of errors into docs/joints.md. Chains with the solve are cases of the report.
//   --draw   measure nothing: page and table of the numbers of last time
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { drawPages, readBeside } from '../draw/report.js';
import { columnsOf, type Table } from '../draw/table.js';
import { MACHINE, today } from '../run/machine.js';
import { readReport } from '../run/report.js';
import { costs } from './cost.js';
import { endurance } from './endurance.js';
import { chainsIterated } from './errors.js';
import { readJoints, writeJoints, type JointNumbers } from './numbers.js';
import { costTable, enduranceTable, errorTable } from './tables.js';
import { withErrors } from './text.js';

const { values: options } = parseArgs({ options: { draw: { type: 'boolean', default: false } } });

const TEXT = new URL('../../docs/joints.md', import.meta.url);

const measured = async (): Promise<JointNumbers> => ({
  machine: MACHINE,
  date: today(),
  iterated: await chainsIterated(),
  endurance: await endurance(),
  costs: await costs(),
});

const print = ({ head, rows }: Table): void => console.log(`\n${columnsOf([head, ...rows], 1)}`);

if (!options.draw) writeJoints(await measured());
const numbers = readJoints();
const report = readReport();
print(errorTable(report.rows, numbers.iterated));
print(enduranceTable(numbers.endurance));
print(costTable(numbers.costs));
writeFileSync(TEXT, withErrors(readFileSync(TEXT, 'utf8'), numbers));
drawPages(report, { ...readBeside(), joints: numbers });
