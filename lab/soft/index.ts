// npm run lab -- soft: ropes and cloths beside Jolt's soft bodies and Ammo's, each at several costs, against closed forms.
// Writes lab/report/soft.json, the tables in docs/soft.md and their picture. Three to four minutes.
//   --case <id>   only this scene (on stands for all of on-*); others stay as they were measured
//   --draw        measure nothing: tables and picture of the numbers of last time
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { softPicture } from '../draw/soft-chart.js';
import { columnsOf, type Table } from '../draw/table.js';
import { progress } from '../run/progress.js';
import { softCases } from './cases.js';
import { measureCase } from './measure.js';
import { readSoft, withCell, writeSoft } from './numbers.js';
import { besideTable, costTable, levelTable, missed, worse } from './tables.js';
import { withSoft } from './text.js';
import { versionsOf } from './versions.js';

const { values: options } = parseArgs({
  options: { case: { type: 'string' }, draw: { type: 'boolean', default: false } },
});

const TEXT = new URL('../../docs/soft.md', import.meta.url);
const PICTURE = new URL('../../docs/pictures/soft.svg', import.meta.url);

const { case: only } = options;
const chosen = softCases.filter(({ id }) => !only || id === only || id.startsWith(`${only}-`));
if (chosen.length === 0) throw new Error('no such scene');

const show = ({ head, rows }: Table): void => console.log(`\n${columnsOf([head, ...rows], 1)}`);

/** What was measured is kept, if the next scene is broken off. */
async function measure(): Promise<void> {
  for (const which of chosen) {
    const start = process.cpuUsage();
    const cell = await measureCase(which, progress);
    const { user, system } = process.cpuUsage(start);
    progress('');
    console.log(`${which.name}: ${((user + system) / 1e6).toFixed(0)} s of the processor`);
    writeSoft({ versions: versionsOf(), cells: withCell(readSoft().cells, cell) });
  }
}

if (!options.draw) await measure();
const numbers = readSoft();
for (const table of [levelTable, besideTable, costTable]) show(table(numbers));
console.log(`\nmisses its aim: ${missed(numbers).join('; ') || 'none'}`);
console.log(`finer and further off: ${worse(numbers).join('; ') || 'none'}`);
writeFileSync(PICTURE, softPicture(numbers));
writeFileSync(TEXT, withSoft(readFileSync(TEXT, 'utf8'), numbers));
// Jolt and Ammo hold on to the process.
process.exit();
