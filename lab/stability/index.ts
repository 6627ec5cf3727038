// npm run lab -- stability: every hard case at every level. Writes lab/report/stability.json cell
// by cell, draws the matrix among the report's pages and puts its tables into docs/stability.md.
//   --case <id>        only this case (S2 stands for all of S2 …), and print it
//   --level <name>     only this level
//   --lowest           each case only at the lowest level that promises it
//   --browsers         the promised cells in Chromium, Firefox and WebKit instead of Node
//   --browser <name>   in this one alone: chromium, firefox or webkit
//   --others           other engines instead of ours
//   --fresh            measure anew what an earlier, perhaps broken-off, run has measured already
//   --draw             measure nothing: draw page and tables of the numbers of last time
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
// @ts-expect-error plain JavaScript
import { BROWSERS } from '../../tools/docs/open-browser.js';
import { drawPages, readBeside } from '../draw/report.js';
import { matrixPicture } from '../draw/stability-picture.js';
import { readReport } from '../run/report.js';
import { stabilityCases } from './cases/index.js';
import { levelsOf, promises } from './levels.js';
import { measureHere, measureIn, measureOthers, type Wanted } from './measure.js';
import { readStability } from './numbers.js';
import { promiseCount } from './table.js';
import { withMatrix } from './text.js';

const PICTURE = new URL('../../docs/pictures/stability.svg', import.meta.url);
const TEXT = new URL('../../docs/stability.md', import.meta.url);

const { values: options } = parseArgs({
  options: {
    case: { type: 'string' },
    level: { type: 'string' },
    lowest: { type: 'boolean', default: false },
    browsers: { type: 'boolean', default: false },
    browser: { type: 'string' },
    others: { type: 'boolean', default: false },
    fresh: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
});

const chosen = stabilityCases.filter(
  ({ id }) => !options.case || id === options.case || id.startsWith(`${options.case} `),
);
if (chosen.length === 0) throw new Error('no such case');

const wanted: Wanted[] = chosen.flatMap((which) =>
  levelsOf(which)
    .filter((level) => !options.level || level === options.level)
    .filter((level) => !options.lowest || level === which.promisedFrom)
    .map((level) => [which, level] as const),
);

async function measure(): Promise<void> {
  if (options.others) return measureOthers(chosen, options);
  if (!options.browsers && !options.browser) return measureHere(wanted, options);
  const promised = wanted.filter(([which, level]) => promises(which, level));
  for (const browser of options.browser ? [options.browser] : (BROWSERS as string[]))
    await measureIn(browser, promised, options);
}

if (!options.draw) await measure();
const numbers = readStability();
const { kept, broken } = promiseCount(numbers);
console.log(`${kept} promised cells hold, ${broken.length} break`);
for (const name of broken) console.log(`  ${name}`);
writeFileSync(PICTURE, `${matrixPicture(numbers)}\n`);
writeFileSync(TEXT, withMatrix(readFileSync(TEXT, 'utf8'), numbers));
drawPages(readReport(), readBeside());
// A browser that was opened may take a while to go.
process.exit(broken.length > 0 ? 1 : 0);
