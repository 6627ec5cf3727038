// npm test: installs what is missing, checks, builds, runs all tests. Options:
//   --only core|mutants|chromium|firefox|webkit   one stage (and neither type-check nor lint)
//   --files <glob>                        only these test files, e.g. 'test/browser/joints/*.test.ts'
//   --no-build                            with dist/ as it is
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { canShowWindows, ensureChromium, findFirefox, findWebKit } from './browsers.js';
import { globSync, matches } from './files.js';
import { ensurePackages } from './install.js';
import { BIN, runNode } from './processes.js';

const { values: options } = parseArgs({
  options: {
    only: { type: 'string' },
    files: { type: 'string' },
    'no-build': { type: 'boolean', default: false },
  },
});

const temporary = mkdtempSync(join(tmpdir(), 'x3d-physics-test-'));
const seconds = (since) => ((Date.now() - since) / 1000).toFixed(1);
const title = (text) => console.log(`\n── ${text} ${'─'.repeat(Math.max(2, 70 - text.length))}`);

/** Test files below a folder that `--files` lets through. */
const testFiles = (folder) =>
  globSync(`test/${folder}/**/*.test.ts`).filter(
    (file) => !options.files || matches(file, options.files),
  );

/** Type check, lint and format: what they say is shown only where they fail. */
async function staticChecks() {
  title('types, lint, format');
  const start = Date.now();
  const checks = await Promise.all(
    [
      ['types', [BIN.tsc, '--noEmit']],
      ['lint', [BIN.eslint, '.']],
      ['format', [BIN.prettier, '--check', '.']],
    ].map(async ([name, args]) => ({ name, ...(await runNode(args, { quiet: true })) })),
  );
  for (const { name, ok, output } of checks) {
    console.log(ok ? `✓ ${name}` : `✗ ${name}\n${output}`);
  }
  console.log(`${seconds(start)} s`);
  return checks.filter((check) => !check.ok).map((check) => check.name);
}

/** The core in Node, by Node's own runner; its counts are read from a second, TAP report. */
async function coreTests(files) {
  const report = join(temporary, 'core.tap');
  const { ok } = await runNode([
    ...['--import', 'tsx', '--test'],
    ...['--test-reporter=spec', '--test-reporter-destination=stdout'],
    ...['--test-reporter=tap', `--test-reporter-destination=${report}`],
    ...files,
  ]);
  const tap = readFileSync(report, 'utf8');
  const count = (word) => Number(tap.match(new RegExp(`^# ${word} (\\d+)$`, 'm'))?.[1] ?? 0);
  return { ok, passed: count('pass'), failed: count('fail') + count('cancelled') };
}

/** Each mutant that no test notices counts as a failed test. */
async function mutants() {
  const { ok, output } = await runNode(['--import', 'tsx', 'tools/mutants.ts'], { quiet: true });
  const [killed, survived] = output.match(/(\d+) killed, (\d+) survived/)?.slice(1) ?? [0, 1];
  if (!ok) console.log(output);
  return { ok, passed: Number(killed), failed: Number(survived) };
}

const browserTests = (config) => async (files) => {
  const report = join(temporary, `${config}.json`);
  const { ok } = await runNode([BIN.wtr, '--config', config, '--files', ...files], {
    env: { TEST_COUNTS: report },
  });
  try {
    return { ok, ...JSON.parse(readFileSync(report, 'utf8')) };
  } catch {
    return { ok: false, passed: 0, failed: 1 }; // The runner itself did not come to its end.
  }
};

const STAGES = [
  { name: 'core', folder: 'core', missing: () => null, run: coreTests },
  { name: 'mutants', folder: 'core', missing: () => null, run: mutants },
  {
    name: 'chromium',
    folder: 'browser',
    missing: () => null,
    run: browserTests('web-test-runner.config.js'),
  },
  {
    name: 'firefox',
    folder: 'browser',
    missing: () => missingWindow() ?? (findFirefox() ? null : 'Firefox is not installed'),
    run: browserTests('web-test-runner.firefox.config.js'),
  },
  {
    name: 'webkit',
    folder: 'browser',
    missing: () =>
      missingWindow() ?? (findWebKit() ? null : 'WebKitGTK (webkit2gtk-driver) is not installed'),
    run: browserTests('web-test-runner.webkit.config.js'),
  },
];
const missingWindow = () => (canShowWindows() ? null : 'no display, and Xvfb is not installed');

async function runStage(stage) {
  const files = testFiles(stage.folder);
  if (files.length === 0) return { ...stage, note: 'no test files' };
  const missing = stage.missing();
  if (missing) {
    // Asked for by name it must run; otherwise it runs where it can.
    if (stage.name === options.only) throw new Error(`${stage.name}: ${missing}`);
    return { ...stage, note: `left out: ${missing}` };
  }
  title(stage.name);
  const start = Date.now();
  const result = await stage.run(files);
  // A runner may fail without a failed test, for instance on an error between tests.
  if (!result.ok && result.failed === 0) result.failed = 1;
  return { ...stage, ...result, time: seconds(start) };
}

function finish(results, failedBefore = []) {
  rmSync(temporary, { recursive: true, force: true });
  title('summary');
  for (const name of failedBefore) console.log(`✗ ${name} failed`);
  for (const { name, note, passed, failed, time } of results) {
    const mark = note ? '–' : failed ? '✗' : '✓';
    console.log(`${mark} ${name}: ${note ?? `${passed} passed, ${failed} failed, ${time} s`}`);
  }
  const total = (key) => results.reduce((sum, result) => sum + (result[key] ?? 0), 0);
  const passed = total('passed');
  const failed = total('failed') + failedBefore.length;
  if (passed + failed === 0) console.log('No test ran.');
  console.log(`${passed} passed, ${failed} failed`);
  process.exit(failed === 0 && passed > 0 ? 0 : 1);
}

async function main() {
  const stages = STAGES.filter(({ name }) => !options.only || name === options.only);
  if (stages.length === 0) throw new Error(`--only knows ${STAGES.map((s) => s.name).join(', ')}`);
  await ensurePackages();
  if (stages.some(({ name }) => name === 'chromium'))
    process.env.CHROME_PATH = await ensureChromium();
  if (!options.only) {
    const failed = await staticChecks();
    if (failed.length > 0) finish([], failed);
  }
  if (!options['no-build']) {
    title('build');
    if (!(await runNode(['tools/build.js'])).ok) finish([], ['build']);
  }
  const results = [];
  for (const stage of stages) results.push(await runStage(stage));
  finish(results);
}

main().catch((error) => {
  console.error(error.message);
  finish([], ['set-up']);
});
