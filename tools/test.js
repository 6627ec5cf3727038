// npm test: installs what is missing, checks types, lint and format, builds, runs the quick stages: minutes.
// npm run test:all: every stage. Options:
//   --all                  the quick stages, then the others
//   --rest                 the others only
//   --only core,mutants    these stages only (and neither types nor lint); names: see stages.js
//   --files <glob>         only these test files, e.g. 'test/core/effects/**/*.test.ts'
//   --no-build             with dist/ as it is
//   --strict               a stage that can't run here fails; --may-miss content: but not this one
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { ensureChromium } from './browsers.js';
import { globSync, matches } from './files.js';
import { ensurePackages } from './install.js';
import { BIN, runNode } from './processes.js';

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

const temporary = mkdtempSync(join(tmpdir(), 'x3d-physics-test-'));
const seconds = (since) => ((Date.now() - since) / 1000).toFixed(1);
const title = (text) => console.log(`\n── ${text} ${'─'.repeat(Math.max(2, 70 - text.length))}`);

/** Types, lint, format, the order of the rooms and the build, side by side; what they say is shown only where they fail. */
async function checkAndBuild(checks) {
  title(checks.map(([name]) => name).join(', '));
  const start = Date.now();
  const results = await Promise.all(
    checks.map(async ([name, args]) => ({ name, ...(await runNode(args, { quiet: true })) })),
  );
  for (const { name, ok, output } of results) {
    console.log(ok ? `✓ ${name}` : `✗ ${name}\n${output}`);
  }
  console.log(`${seconds(start)} s`);
  return results.filter((check) => !check.ok).map((check) => check.name);
}

const CHECKS = [
  ['types', [BIN.tsc, '--noEmit']],
  ['lint', [BIN.eslint, '.']],
  ['format', [BIN.prettier, '--check', '.']],
  ['rooms', ['--import', 'tsx', 'tools/rooms.ts']],
];
/** What `npm test` runs needs no declarations. */
const BUILD = [
  'build',
  ['tools/build.js', ...(options.all || options.rest || options.only ? [] : ['--no-types'])],
];

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
  title(stage.name);
  const start = Date.now();
  const result = await stage.run(files, temporary);
  // A runner may fail without a failed test, for instance on an error between tests.
  if (!result.ok && result.failed === 0) result.failed = 1;
  return { ...stage, ...result, time: seconds(start) };
}

/** Asked for by name, or where everything must run, it has failed; otherwise it runs where it can. */
function leftOut(stage, missing) {
  const mayMiss = options['may-miss']
    .split(',')
    .some((name) => name && stage.name.startsWith(name));
  const must = (options.strict && !mayMiss) || options.only?.split(',').includes(stage.name);
  return { ...stage, note: `left out: ${missing}`, [must ? 'failed' : 'skipped']: 1 };
}

function finish(results, failedBefore = []) {
  rmSync(temporary, { recursive: true, force: true });
  title('summary');
  for (const name of failedBefore) console.log(`✗ ${name} failed`);
  for (const { name, note, passed, failed, skipped, time } of results) {
    const mark = failed ? '✗' : note ? '–' : '✓';
    const counts = `${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`;
    console.log(`${mark} ${name}: ${note ?? `${counts}, ${time} s`}`);
  }
  const total = (key) => results.reduce((sum, result) => sum + (result[key] ?? 0), 0);
  const [passed, failed, skipped] = ['passed', 'failed', 'skipped'].map(total);
  const allFailed = failed + failedBefore.length;
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

async function main() {
  const start = Date.now();
  await ensurePackages();
  // Only now: they import packages.
  const { STAGES } = await import('./stages.js');
  const stages = chosen(STAGES);
  process.env.CHROME_PATH = await ensureChromium();
  const checks = options.only || options.rest ? [] : CHECKS;
  const failed = await checkAndBuild(options['no-build'] ? checks : [...checks, BUILD]);
  if (failed.length > 0) finish([], failed);
  // A browser that draws leaves some of two cores to the core's tests.
  const results = await Promise.all(stages.filter(({ quick }) => quick).map(runStage));
  for (const stage of stages) if (!stage.quick) results.push(await runStage(stage));
  console.log(`\n${seconds(start)} s in all`);
  finish(results);
}

main().catch((error) => {
  console.error(error.message);
  finish([], ['set-up']);
});
