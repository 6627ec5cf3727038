// What the command measures, cell by cell: each is written when it is found.
import { existsSync } from 'node:fs';
import type { LevelName } from '../../physics-core/inside.js';
import { MACHINE, today } from '../run/machine.js';
import { progress } from '../run/progress.js';
import { CellPage } from './browsers/page.js';
import type { Cell, StabilityCase } from './case.js';
import { stabilityCases } from './cases/index.js';
import {
  FILE,
  readStability,
  writeStability,
  type BrowserNumbers,
  type StabilityNumbers,
} from './numbers.js';
import { OTHERS, runOther } from './others.js';
import { runCell } from './run.js';
import { wordsOf } from './table.js';

export type Wanted = readonly [which: StabilityCase, level: LevelName];

/** `fresh`: anew what an earlier, perhaps broken-off, run has measured already. */
export interface How {
  fresh: boolean;
}

/** Of cases that there still are. */
const still = <T>(all: Record<string, T> = {}): Record<string, T> =>
  Object.fromEntries(stabilityCases.flatMap(({ id }) => (all[id] ? [[id, all[id]]] : [])));

function known(): StabilityNumbers {
  const before: Partial<StabilityNumbers> = existsSync(FILE) ? readStability() : {};
  const { cells, browsers = {}, others } = before;
  return {
    machine: MACHINE,
    date: today(),
    cells: still(cells),
    browsers,
    others: still(others),
  };
}

/** One cell: measured, printed and written. */
async function keep(
  numbers: StabilityNumbers,
  name: string,
  which: StabilityCase,
  run: () => Promise<Cell>,
  put: (cell: Cell) => void,
): Promise<void> {
  progress(name);
  const start = performance.now();
  const cell = await run();
  const seconds = ((performance.now() - start) / 1000).toFixed(1);
  put(cell);
  progress('');
  console.log(`${name}: ${wordsOf(which, cell)} (${seconds} s)`);
  writeStability(numbers);
}

export async function measureHere(wanted: readonly Wanted[], { fresh }: How): Promise<void> {
  const numbers = known();
  for (const [which, level] of wanted) {
    const row = (numbers.cells[which.id] ??= {});
    // Without bits it is from before they were kept.
    if (row[level]?.bits && !fresh) continue;
    const put = (cell: Cell) => (row[level] = cell);
    await keep(numbers, `${which.id}, ${level}`, which, () => runCell(which, level), put);
  }
}

export async function measureOthers(
  chosen: readonly StabilityCase[],
  { fresh }: How,
): Promise<void> {
  const numbers = known();
  for (const which of chosen) {
    const told = which.told?.();
    if (!told) continue;
    const row = (numbers.others[which.id] ??= {});
    for (const other of OTHERS) {
      const { id, name } = other.engine;
      if (row[id] && !fresh) continue;
      const put = (cell: Cell) => (row[id] = cell);
      const run = () => runOther(which, told, other);
      await keep(numbers, `${which.id}, ${name}`, which, run, put);
    }
  }
}

/** In one browser. A cell counts as known where it has the bits that Node has now. */
export async function measureIn(
  browser: string,
  wanted: readonly Wanted[],
  { fresh }: How,
): Promise<void> {
  const numbers = known();
  const before: Partial<BrowserNumbers> = numbers.browsers[browser] ?? {};
  const cells = still(before.cells);
  const page = await CellPage.open(browser);
  for (const [which, level] of wanted) {
    const row = (cells[which.id] ??= {});
    const bits = numbers.cells[which.id]?.[level]?.bits;
    if (bits && row[level]?.bits === bits && !fresh) continue;
    const run = () => page.run({ id: which.id, level });
    await keep(numbers, `${which.id}, ${level}, ${browser}`, which, run, (cell) => {
      row[level] = cell;
      numbers.browsers[browser] = { version: page.version, date: today(), cells };
    });
  }
  await page.close();
}
