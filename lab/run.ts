// npm run lab: every case of the accuracy lab through every engine; writes lab/report/ and the picture of the README.
//   --quick           under two minutes: runs what is cheap, once, and compares it with the report to the last bit
//   --case <id>       only this case (A6 stands for A6.1, A6.2 …), and print it; no report
//   --engine <id>     only ours, ammo, x-ite, cannon, rapier or jolt, and print it; no report
//   --level <name>    only our engine at this level, and print it; no report
//   --fresh           measure anew what an earlier, perhaps broken-off, run has measured already
//   --draw            measure nothing: draw the report from its numbers
import { parseArgs } from 'node:util';
import { cases } from './cases/index.js';
import { engines } from './engines/index.js';
import { readReport, writeReport } from './draw/report.js';
import { printed } from './draw/print.js';
import { measure, THOROUGH, type Entry } from './run/measure.js';
import { compareWith } from './run/quick.js';
import type { Results } from './run/row.js';

const { values: options } = parseArgs({
  options: {
    quick: { type: 'boolean', default: false },
    case: { type: 'string' },
    engine: { type: 'string' },
    level: { type: 'string' },
    fresh: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
});

const { case: id, engine: only, level } = options;
const chosen = cases.filter((one) => !id || one.id === id || one.id.startsWith(`${id}.`));
const entries: Entry[] = engines
  .filter((engine) => (level ? engine.id === 'ours' : !only || engine.id === only))
  .flatMap((engine) => engine.settings.map((setting) => ({ engine, setting })))
  .filter(({ setting }) => !level || setting.level === level);
if (chosen.length === 0 || entries.length === 0) throw new Error('no such case, engine or level');

/** One line that is written over. */
const progress = (text: string): void => {
  if (process.stderr.isTTY) process.stderr.write(`\r\x1b[K${text}`);
};

async function measureAll(): Promise<Results> {
  const all: Results = { rows: [], notOffered: [] };
  for (const [i, which] of chosen.entries()) {
    const start = performance.now();
    const name = `${which.id} ${which.name}`;
    const { rows, notOffered } = await measure(which, entries, {
      pains: THOROUGH,
      fresh: options.fresh,
      progress: (doing) => progress(`case ${i + 1} of ${chosen.length}, ${name}: ${doing}`),
    });
    all.rows.push(...rows);
    all.notOffered.push(...notOffered);
    progress('');
    console.error(`${name}: ${((performance.now() - start) / 1000).toFixed(1)} s`);
  }
  return all;
}

if (options.draw) writeReport(readReport());
else if (options.quick) process.exitCode = await compareWith(readReport(), cases, progress);
else {
  const results = await measureAll();
  if (id || only || level) console.log(printed(chosen, results));
  else writeReport(results);
}
