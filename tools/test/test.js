// npm test: installs what is missing, then types, rooms, lint and format of what changed, the core, Chromium.
// npm run test:all: every stage. Options:
//   --all                  the quick stages, then the others
//   --rest                 the others only
//   --only core,mutants    these stages only (and none of the checks); names: see stages.js
//   --files <glob>         only these test files, e.g. 'test/core/effects/**/*.test.ts'
//   --no-build             with dist/ as it is
//   --strict               a stage that can't run here fails; --may-miss content: but not this one
import { mkdtempSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { ensureChromium } from './browsers.js';
import { globSync, matches } from '../files.js';
import { ensurePackages } from '../build/install.js';
import { runNode } from '../processes.js';
import { countProcessorTime, inStage, isCounted, processorSeconds } from '../processor-time.js';

const { values: options } = parseArgs({
  options: {
    all: { type: 'boolean', default: false },
    rest: { type: 'boolean', default: false },
    only: { type: 'string' },
    files: { type: 'string' },
    'no-build': { type: 'boolean', default: false },
    strict: { type: 'boolean', default: false },
    'may-miss': { type: 'string', default: '' },
  },
});

/** Seconds of the processor that `npm test` may take in all: what people wait for before each commit. */
const BUDGET = 150;

const CORES = availableParallelism();

const isQuickRun = !options.all && !options.rest && !options.only;

const temporary = mkdtempSync(join(tmpdir(), 'x3d-physics-test-'));
const seconds = (since) => ((Date.now() - since) / 1000).toFixed(1);
const title = (text) => console.log(`\n── ${text} ${'─'.repeat(Math.max(2, 70 - text.length))}`);

/** Side by side, each told of as it ends; what it says is shown only where it fails. Names of those that failed. */
async function runChecks(checks) {
  const start = Date.now();
  const failed = [];
  const runOne = async ([name, args]) => {
    const { ok, output } = await inStage(name, () => runNode(args, { quiet: true }));
    console.log(ok ? `✓ ${name}, ${seconds(start)} s` : `✗ ${name}\n${output}`);
    if (!ok) failed.push(name);
  };
  await Promise.all(checks.map(runOne));
  return failed;
}

/** Test files of a stage; those that `--files` names, be they quick or long. */
const filesOf = ({ folders = [], takes = () => true }) =>
  folders
    .flatMap((folder) => globSync(`test/${folder}/**/*.test.ts`))
    .filter((file) => (options.files ? matches(file, options.files) : takes(file)));

async function runStage(stage) {
  const files = filesOf(stage);
  if (stage.folders && files.length === 0) return { ...stage, note: 'no test files' };
  const missing = stage.missing?.();
  if (missing) return leftOut(stage, missing);
  title(`${stage.name} begins`);
  const start = Date.now();
  const result = await inStage(stage.name, () => stage.run(files, temporary, stage.name));
  // A runner may fail without a failed test, for instance on an error between tests.
  if (!result.ok && result.failed === 0) result.failed = 1;
  console.log(`${stage.name} ends after ${seconds(start)} s`);
  return { ...stage, ...result, time: seconds(start) };
}

/** Each as soon as it finds its cores free; what says nothing of cores has all of them for itself. */
async function runStages(stages) {
  const running = new Set();
  let free = CORES;
  const results = stages.map(async () => {});
  for (const [i, stage] of stages.entries()) {
    const cores = Math.min(stage.cores ?? CORES, CORES);
    while (free < cores) await Promise.race(running);
    free -= cores;
    const run = runStage(stage).finally(() => {
      free += cores;
      running.delete(run);
    });
    running.add(run);
    results[i] = run;
  }
  return Promise.all(results);
}

/** Asked for by name, or where everything must run, it has failed; otherwise it runs where it can. */
function leftOut(stage, missing) {
  const mayMiss = options['may-miss']
    .split(',')
    .some((name) => name && stage.name.startsWith(name));
  const must = (options.strict && !mayMiss) || options.only?.split(',').includes(stage.name);
  return { ...stage, note: `left out: ${missing}`, [must ? 'failed' : 'skipped']: 1 };
}

/** What each stage took of the processor, and whether that is more than it should be: told, as machines differ. */
function tellProcessorTime() {
  if (!isCounted) return;
  title('seconds of the processor');
  const stages = processorSeconds();
  for (const [name, taken] of stages) console.log(`${taken.toFixed(1).padStart(7)}  ${name}`);
  const all = stages.reduce((sum, [, taken]) => sum + taken, 0);
  console.log(`${all.toFixed(1).padStart(7)}  in all${isQuickRun ? `, of ${BUDGET}` : ''}`);
  if (isQuickRun && all > BUDGET)
    console.log(`npm test is to take ${BUDGET} s: what is dear belongs to test:all.`);
}

/** What failed is said once more: it may stand a thousand lines above. */
function tellFaults(results) {
  for (const { name, faults } of results) {
    if (!faults?.length) continue;
    title(`what failed in ${name}`);
    for (const fault of faults) console.log(fault);
  }
}

function finish(results, failed = []) {
  rmSync(temporary, { recursive: true, force: true });
  tellProcessorTime();
  tellFaults(results);
  title('summary');
  for (const name of failed) console.log(`✗ ${name} failed`);
  for (const { name, note, passed, failed, skipped, time } of results) {
    const mark = failed ? '✗' : note ? '–' : '✓';
    const counts = `${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`;
    console.log(`${mark} ${name}: ${note ?? `${counts}, ${time} s`}`);
  }
  const total = (key) => results.reduce((sum, result) => sum + (result[key] ?? 0), 0);
  const [passed, failedTests, skipped] = ['passed', 'failed', 'skipped'].map(total);
  const allFailed = failedTests + failed.length;
  if (isQuickRun) console.log('Everything else: npm run test:all');
  if (passed + allFailed === 0) console.log('No test ran.');
  console.log(`${passed} passed, ${allFailed} failed${skipped ? `, ${skipped} skipped` : ''}`);
  process.exit(allFailed === 0 && passed > 0 ? 0 : 1);
}

function chosen(stages) {
  if (options.all) return stages;
  if (options.rest) return stages.filter(({ quick }) => !quick);
  const only = options.only?.split(',');
  const unknown = only?.find((name) => !stages.some((stage) => stage.name === name));
  if (unknown) throw new Error(`--only knows ${stages.map(({ name }) => name).join(', ')}`);
  return stages.filter(({ name, quick }) => (only ? only.includes(name) : quick));
}

/** What the checks, and the build where a stage looks into it, leave to say. */
async function prepare(stages) {
  const { quickChecks } = await import('../check/checks.js');
  const checks = options.only || options.rest ? [] : await quickChecks();
  // The quick stages run on the sources.
  const builds = !options['no-build'] && stages.some(({ quick }) => !quick);
  if (builds) checks.push(['build', ['tools/build/build.js']]);
  if (checks.length === 0) return [];
  title(checks.map(([name]) => name).join(', '));
  return runChecks(checks);
}

async function main() {
  const start = Date.now();
  await ensurePackages();
  countProcessorTime();
  process.env.CHROME_PATH = await ensureChromium();
  // Only now: they import packages.
  const { STAGES } = await import('./stages.js');
  const stages = chosen(STAGES);
  const failed = await prepare(stages);
  if (failed.length > 0) finish([], failed);
  const results = await runStages(stages);
  console.log(`\n${seconds(start)} s in all`);
  finish(results);
}

main().catch((error) => {
  console.error(error.message);
  finish([], ['set-up']);
});
