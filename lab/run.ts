// npm run lab: every case of the accuracy lab through every engine; writes lab/report/rows.json, draws the report's pages
// beside it and the picture of the page on accuracy.
//   --quick           under two minutes: runs what is cheap, once, and compares it with the report to the last bit
//   --case <id>       only this case (bounce stands for all of bounce-*), and print it; no report
//   --keep            with --case: and put it into the report
//   --engine <id>     only ours, ammo, x-ite, cannon, rapier or jolt, and print it; no report
//   --level <name>    only our engine at this level, and print it; no report
//   --fresh           measure anew what an earlier, perhaps broken-off, run has measured already
//   --draw            measure nothing: draw pages and picture from the report's numbers
import { parseArgs } from 'node:util';
import { cases, casesNamed } from './cases/index.js';
import { engines } from './engines/index.js';
import { drawPages, drawPicture, readBeside } from './draw/report.js';
import { printed } from './draw/print.js';
import { measureCases, THOROUGH, type Entry } from './run/measure.js';
import { progress } from './run/progress.js';
import { compareWith } from './run/quick.js';
import { readReport, runOf, withCases, writeReport } from './run/report.js';
import type { Results } from './run/row.js';

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    case: { type: 'string' },
    keep: { type: 'boolean', default: false },
    engine: { type: 'string' },
    level: { type: 'string' },
    fresh: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
});

const { case: name, engine: only, level, fresh } = options;
const chosen = name ? casesNamed(name) : cases;
const entries: Entry[] = engines
  .filter((engine) => (level ? engine.id === 'ours' : !only || engine.id === only))
  .flatMap((engine) => engine.settings.map((setting) => ({ engine, setting })))
  .filter(({ setting }) => !level || setting.level === level);
if (chosen.length === 0 || entries.length === 0) throw new Error('no such case, engine or level');
const inPart = Boolean(only ?? level);
if (options.keep && inPart) throw new Error('a report has all engines and levels of a case');

function draw(results: Results): void {
  drawPages(results, readBeside());
  drawPicture(results);
}

async function measureAll(): Promise<void> {
  const measured = await measureCases(chosen, entries, { pains: THOROUGH, fresh, progress });
  if (name || inPart) console.log(printed(chosen, measured));
  if (inPart || (name && !options.keep)) return;
  const results = { runs: [runOf(chosen)], ...measured };
  writeReport(name ? withCases(readReport(), results) : results);
  draw(readReport());
}

if (options.draw) draw(readReport());
else if (options.quick) process.exitCode = await compareWith(readReport(), cases, progress);
else await measureAll();
