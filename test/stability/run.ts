// node --import tsx test/stability/run.ts: each hard case at the lowest level that promises it, in Node and in
// browsers, side by side. It holds everywhere, and comes to the same bits; in Node also with its steps taken on the other
// side of a line, but for those of cases-here.ts.
//   --browsers chromium,firefox   beside Node, all three if nothing is said
//   --alone                       what is left to Node: what takes long, and further levels
//   S1 'S9 box'                   these cases alone
import { parseArgs } from 'node:util';
import { CellPage } from '../../lab/stability/browsers/page.js';
import type { Cell, StabilityCase } from '../../lab/stability/case.js';
import { stabilityCases } from '../../lab/stability/cases/index.js';
import { toText } from '../../lab/stability/json.js';
import { runCell } from '../../lab/stability/run.js';
import { wordsOf } from '../../lab/stability/table.js';
import type { LevelName } from '../../physics-core/inside.js';
// @ts-expect-error plain JavaScript
import { BROWSERS } from '../../tools/docs/open-browser.js';
import { goAwayAtOnce } from '../core/thread/at-once.js';
import { casesHere } from './cases-here.js';

const { values, positionals: ids } = parseArgs({
  options: { browsers: { type: 'string' }, alone: { type: 'boolean', default: false } },
  allowPositionals: true,
});

/** Milliseconds between two words of how far it is. */
const APART = 10_000;

const { alone } = values;
const browsers = alone ? [] : (values.browsers?.split(',') ?? (BROWSERS as string[]));

const pages = await Promise.all(
  browsers.map(async (name) => ({ name, page: await CellPage.open(name) })),
);

const counts = { passed: 0, failed: 0 };

function count(where: string, which: StabilityCase, level: LevelName, objection?: string) {
  if (objection) console.log(`${which.id} at ${level} in ${where}: ${objection}`);
  counts[objection ? 'failed' : 'passed']++;
}

/** What is wrong in a browser, if anything. */
function objection(which: StabilityCase, there: Cell, { bits }: Cell): string | undefined {
  if (!there.holds) return wordsOf(which, there);
  if (there.bits !== bits) return `${there.bits} and not ${bits}, as in Node`;
}

/** What is wrong with its steps taken on the other side, if anything: each number is the same. */
function otherwise(which: StabilityCase, sides: Cell, here: Cell): string | undefined {
  if (toText(sides) !== toText(here)) return `${toText(sides)} and not ${toText(here)}, as here`;
}

/** A cell in Node, which nothing reaches meanwhile, as soon as it has begun in all pages. */
async function runEverywhere(which: StabilityCase, level: LevelName) {
  const begun: Promise<void>[] = [];
  const there = pages.map(({ page }) => {
    let found!: Promise<Cell>;
    begun.push(
      new Promise((begins, fails) => {
        found = page.run({ id: which.id, level }, async () => begins());
        found.catch(fails);
      }),
    );
    return found;
  });
  await Promise.all(begun);
  const here = await runCell(which, level);
  const onBothSides = !alone && !casesHere.has(which.id);
  const sides = onBothSides ? await runCell(which, level, goAwayAtOnce) : undefined;
  return { here, sides, there: await Promise.all(there) };
}

async function look(which: StabilityCase, level: LevelName) {
  const { here, sides, there } = await runEverywhere(which, level);
  count('Node', which, level, here.holds ? undefined : wordsOf(which, here));
  if (sides) count('Node, on the other side', which, level, otherwise(which, sides, here));
  for (const [i, { name }] of pages.entries())
    count(name, which, level, objection(which, there[i]!, here));
}

const levelsOf = ({ promisedFrom, alsoTested = [], slow }: StabilityCase): LevelName[] => {
  if (!promisedFrom) return [];
  if (slow) return alone ? [promisedFrom, ...alsoTested] : [];
  return alone ? alsoTested : [promisedFrom];
};

const chosen = stabilityCases
  .filter(({ id }) => ids.length === 0 || ids.includes(id))
  .flatMap((which) => levelsOf(which).map((level) => ({ which, level })));

const start = Date.now();
let told = start;
for (const [i, { which, level }] of chosen.entries()) {
  await look(which, level);
  if (Date.now() - told < APART) continue;
  told = Date.now();
  const share = Math.round((100 * (i + 1)) / chosen.length);
  const where = ['Node', ...browsers].join(', ');
  console.error(
    `… ${where}: ${share} % of ${chosen.length} hard cases, ${Math.round((told - start) / 1000)} s`,
  );
}
await Promise.all(pages.map(({ page }) => page.close()));
console.log(`${counts.passed} passed, ${counts.failed} failed`);
process.exit(counts.failed > 0 ? 1 : 0);
