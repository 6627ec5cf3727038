// npm run lab:stability, or npm run lab -- stability: every hard case at every level. Writes lab/report/stability.json cell
// by cell, draws the matrix among the report's pages and puts its tables into docs/stability.md.
//   --case <id>      only this case (S2 stands for all of S2 …), and print it
//   --level <name>   only this level
//   --others         other engines instead of ours
//   --fresh          measure anew what an earlier, perhaps broken-off, run has measured already
//   --draw           measure nothing: draw page and tables of the numbers of last time
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import type { LevelName } from '../../physics-core/inside.js';
import { drawPages, readBeside } from '../draw/report.js';
import { matrixPicture } from '../draw/stability-picture.js';
import { MACHINE, today } from '../run/machine.js';
import { progress } from '../run/progress.js';
import { readReport } from '../run/report.js';
import type { StabilityCase } from './case.js';
import { stabilityCases } from './cases/index.js';
import { levelsOf } from './levels.js';
import { FILE, readStability, writeStability, type StabilityNumbers } from './numbers.js';
import { OTHERS, runOther } from './others.js';
import { runCell } from './run.js';
import { promiseCount, wordsOf } from './table.js';
import { withMatrix } from './text.js';

const PICTURE = new URL('../../docs/pictures/stability.svg', import.meta.url);
const TEXT = new URL('../../docs/stability.md', import.meta.url);

const { values: options } = parseArgs({
  options: {
    case: { type: 'string' },
    level: { type: 'string' },
    others: { type: 'boolean', default: false },
    fresh: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
  // `stability` itself, where the lab hands on what it was asked for.
  allowPositionals: true,
});

const chosen = stabilityCases.filter(
  ({ id }) => !options.case || id === options.case || id.startsWith(`${options.case} `),
);
if (chosen.length === 0) throw new Error('no such case');

/** With what is known of cases that there still are. */
function known(): StabilityNumbers {
  const before: Partial<StabilityNumbers> = existsSync(FILE) ? readStability() : {};
  const { cells: all = {}, others = {} } = before;
  const cells = Object.fromEntries(
    stabilityCases.flatMap(({ id }) => (all[id] ? [[id, all[id]]] : [])),
  );
  return { machine: MACHINE, date: today(), cells, others };
}

async function measure(numbers: StabilityNumbers, which: StabilityCase, level: LevelName) {
  const row = (numbers.cells[which.id] ??= {});
  if (row[level] && !options.fresh) return;
  progress(`${which.id} at ${level}`);
  const start = performance.now();
  const cell = await runCell(which, level);
  row[level] = cell;
  const seconds = ((performance.now() - start) / 1000).toFixed(1);
  progress('');
  console.log(`${which.id}, ${level}: ${wordsOf(which, cell)} (${seconds} s)`);
  writeStability(numbers);
}

async function measureAll(): Promise<void> {
  const numbers = known();
  for (const which of chosen)
    for (const level of levelsOf(which))
      if (!options.level || options.level === level) await measure(numbers, which, level);
}

async function measureOthers(): Promise<void> {
  const numbers = known();
  for (const which of chosen) {
    const told = which.told?.();
    if (!told) continue;
    const row = (numbers.others[which.id] ??= {});
    for (const other of OTHERS) {
      const [{ id, name }] = other;
      if (row[id] && !options.fresh) continue;
      progress(`${which.id}, ${name}`);
      row[id] = await runOther(which, told, other);
      progress('');
      console.log(`${which.id}, ${name}: ${wordsOf(which, row[id])}`);
      writeStability(numbers);
    }
  }
}

if (!options.draw) await (options.others ? measureOthers() : measureAll());
const numbers = readStability();
const { kept, broken } = promiseCount(numbers);
console.log(`${kept} promised cells hold, ${broken.length} break`);
for (const name of broken) console.log(`  ${name}`);
writeFileSync(PICTURE, `${matrixPicture(numbers)}\n`);
writeFileSync(TEXT, withMatrix(readFileSync(TEXT, 'utf8'), numbers));
drawPages(readReport(), readBeside());
if (broken.length > 0) process.exitCode = 1;
