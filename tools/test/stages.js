// What the tests consist of. `quick` stages are `npm test`; the others follow in `npm run test:all`, side by side where
// cores allow.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { canShowWindows, findFirefox, findWebKit } from './browsers.js';
import { BY_FOLDER, bundleTests, IN_PARTS, TOGETHER } from './bundle-tests.js';
import { add, none } from './count-reporter.js';
import { FORMAT, LINT } from '../check/checks.js';
import { BIN, runNode } from '../processes.js';
import { inSources } from './source-positions.js';

/** Scenes that others made for other X3D browsers. They are no part of the project. */
export const CONTENT = process.env.X3D_CONTENT ?? '../shared/content';

const isLong = (file) => file.endsWith('.long.test.ts');
const isQuick = (file) => !isLong(file);

/**
 * In Node, by Node's own runner, shown where it fails; its counts are read from a second, TAP report. `nameOf` says which
 * files share a process; `env`: what they find in their environment.
 */
const inNode = (nameOf, env) => async (files, temporary, stage) => {
  const report = join(temporary, `${stage}.tap`);
  const args = [
    // Three reporters listen to one stream.
    ...['--disable-warning=MaxListenersExceededWarning', '--test', '--test-concurrency=2'],
    // MB. What a fact makes dies young, and is copied seldom where there is room: a tenth of the time.
    '--max-semi-space-size=64',
    ...['--test-reporter=spec', '--test-reporter-destination=stdout'],
    ...['--test-reporter=./tools/test/progress-reporter.js', '--test-reporter-destination=stderr'],
    ...['--test-reporter=tap', `--test-reporter-destination=${report}`],
    ...(await bundleTests(files, { platform: 'node', stage, nameOf })),
  ];
  const { ok, output } = await runNode(args, { quiet: 'stdout', env });
  if (!ok) console.log(inSources(output));
  const tap = readFileSync(report, 'utf8');
  const count = (word) => Number(tap.match(new RegExp(`^# ${word} (\\d+)$`, 'm'))?.[1] ?? 0);
  return {
    ok,
    passed: count('pass'),
    failed: count('fail') + count('cancelled'),
    skipped: count('skipped'),
    faults: tap.match(/^ *not ok .*$/gm) ?? [],
  };
};

/** Where a script says what was wrong. */
const lastLines = (output) => output.trimEnd().split('\n').slice(-20);

/**
 * A script that closes with `N passed, N failed`, or with two numbers in words of its own. `quiet: 'stdout'`: how far it
 * is it says on the other stream.
 */
const script =
  (args, { counts = /(\d+) passed, (\d+) failed/, quiet = true } = {}) =>
  async () => {
    const { ok, output } = await runNode(args, { quiet });
    const [passed, failed] = output.match(counts)?.slice(1).map(Number) ?? [0, 1];
    if (!ok) console.log(output);
    return { ok, passed, failed, faults: ok ? [] : lastLines(output) };
  };

/** Whether the site was built in this run: those that follow look at the same. */
let isSiteBuilt = false;

/** Builds the site, and looks at it. */
async function site() {
  const result = await script(['--import', 'tsx', 'test/site/run.ts'])();
  isSiteBuilt = true;
  return result;
}

/** Looks at the site, or at its stories, which it builds where that was not done yet. */
const inSite = (args) => () => script(isSiteBuilt ? [...args, '--built'] : args)();

const HARD_CASES = ['--import', 'tsx', 'test/stability/run.ts'];

/** Those that Node runs alone. */
const hardCasesAlone = script([...HARD_CASES, '--alone'], { quiet: 'stdout' });

/** The hard cases in Node and in the browsers that are there. */
async function hardCases() {
  const browsers = ['chromium', !noFirefox() && 'firefox', !noWebKit() && 'webkit'].filter(Boolean);
  const names = browsers.join(',');
  const args = [...HARD_CASES, '--browsers', names];
  return { ...(await script(args, { quiet: 'stdout' })()), skipped: 3 - browsers.length };
}

/** Without the lab's whole hour: its errors come out again to the last bit. */
async function labErrors() {
  const args = ['--import', 'tsx', 'lab/run.ts', '--quick'];
  const { ok, failed, passed: compared } = await script(args, { counts: LAB_COUNTS })();
  return { ok, passed: compared - failed, failed };
}
const LAB_COUNTS = /(\d+) runs compared in \d+ s, (\d+) came out otherwise/;

/** Not what they cost: whether what measures that beside other libraries still runs. */
const particleLab = script(['--import', 'tsx', 'lab/particles/index.ts', '--quick'], {
  counts: /(\d+) rows measured, (\d+) not/,
});

async function lab() {
  const [errors, particles] = [await labErrors(), await particleLab()];
  return {
    ok: errors.ok && particles.ok,
    passed: errors.passed + particles.passed,
    failed: errors.failed + particles.failed,
    faults: particles.faults,
  };
}

/** What the runner has counted so far, and whether it came to its end. */
function countsIn(report) {
  try {
    return JSON.parse(readFileSync(report, 'utf8'));
  } catch {
    return { ended: false, files: {} };
  }
}

/** What the runner says of a file whose browser went away under it. */
const GONE = /interrupted because the browser disconnected/;

/**
 * In a browser, files that `nameOf` puts together in one page. One that dies may take the runner along: what failed with it
 * and what it had not come to is run in another, once, and that is said.
 */
const inBrowser =
  (config, nameOf = BY_FOLDER) =>
  async (files, temporary, stage) => {
    const total = none();
    const faults = [];
    const run = async (bundles, last) => {
      const report = join(temporary, `${stage}${last ? '-again' : ''}.json`);
      const { ok } = await runNode([BIN.wtr, '--config', config, '--files', ...bundles], {
        env: { TEST_COUNTS: report },
      });
      const { ended, files: counted } = countsIn(report);
      const died = ({ failed, faults }) =>
        ended ? faults.some((fault) => GONE.test(fault)) : failed > 0;
      const done = bundles.filter(
        (bundle) => bundle in counted && (last || !died(counted[bundle])),
      );
      for (const bundle of done) {
        add(total, counted[bundle]);
        faults.push(...counted[bundle].faults);
      }
      const left = bundles.filter((bundle) => !done.includes(bundle));
      if (last || left.length === 0)
        return { ok: ended ? ok : left.length === 0, ...total, faults };
      console.log(`The browser ended with ${left[0]}: what is left runs in a new one.`);
      return run(left, true);
    };
    return run(await bundleTests(files, { platform: 'browser', stage, nameOf }), false);
  };

const noWindow = () => (canShowWindows() ? null : 'no display, and Xvfb is not installed');
const noFirefox = () => noWindow() ?? (findFirefox() ? null : 'Firefox is not installed');
const noWebKit = () =>
  noWindow() ?? (findWebKit() ? null : 'WebKitGTK (webkit2gtk-driver) is not installed');
const noContent = () => (existsSync(CONTENT) ? null : `${CONTENT} is not there`);

const CHROMIUM = inBrowser('web-test-runner.config.js');
const QUICKLY = inBrowser('web-test-runner.config.js', IN_PARTS);
const FIREFOX = inBrowser('web-test-runner.firefox.config.js');
const WEBKIT = inBrowser('web-test-runner.webkit.config.js');

/** What Node runs in a moment: the core, and whatever else needs no page. */
const IN_NODE = ['core', 'elements', 'lab', 'references', 'site', 'stories', 'tools'];

/** Of all files; `npm test` has those that changed. */
const check = (args) => async () => {
  const { ok, output } = await runNode(args, { quiet: true });
  if (!ok) console.log(output);
  return { ok, passed: ok ? 1 : 0, failed: ok ? 0 : 1 };
};

/**
 * `folders`: below test/; `takes`: which of their files. `cores`: how many it keeps busy; what needs the machine to itself
 * says nothing. `missing` says why a stage can't run here; it is left out then, which counts as skipped.
 */
export const STAGES = [
  // A browser that draws leaves some of two cores to the core's tests.
  { name: 'core', quick: true, cores: 1, folders: IN_NODE, takes: isQuick, run: inNode(TOGETHER) },
  { name: 'chromium', quick: true, cores: 1, folders: ['browser'], takes: isQuick, run: QUICKLY },

  { name: 'lint', cores: 1, run: check(LINT) },
  { name: 'format', cores: 1, run: check(FORMAT) },

  { name: 'core-long', cores: 1, folders: IN_NODE, takes: isLong, run: inNode(TOGETHER) },

  {
    name: 'elsewhere',
    cores: 1,
    folders: ['core'],
    takes: (file) => !file.includes('core/thread/'),
    run: inNode(TOGETHER, { X3D_ELSEWHERE: 'yes' }),
  },

  // They have two at work by themselves.
  { name: 'soaks', folders: ['soaks'], run: inNode(BY_FOLDER) },
  { name: 'stability', run: hardCases },
  { name: 'docs', run: site },
  { name: 'package', run: script(['tools/test/package.js']) },
  { name: 'examples', run: script(['tools/test/examples.js']) },

  // Two lanes: what takes longest first, so that both end together.
  { name: 'chromium-long', cores: 1, folders: ['browser'], takes: isLong, run: CHROMIUM },
  { name: 'firefox', cores: 1, folders: ['browser'], missing: noFirefox, run: FIREFOX },
  { name: 'webkit', cores: 1, folders: ['browser'], missing: noWebKit, run: WEBKIT },
  { name: 'stability-alone', cores: 1, run: hardCasesAlone },
  { name: 'lab', cores: 1, run: lab },
  {
    name: 'mutants',
    cores: 1,
    run: script(['--import', 'tsx', 'tools/test/mutants.ts'], {
      counts: /(\d+) killed, (\d+) survived/,
    }),
  },
  { name: 'fuzz', cores: 1, run: script(['--import', 'tsx', 'test/fuzz/run.ts']) },
  {
    name: 'fuzz-edits',
    cores: 1,
    run: script(['--import', 'tsx', 'test/fuzz/run.ts', '--edits', '--runs', '2000']),
  },
  {
    name: 'fuzz-look',
    cores: 1,
    run: script(['--import', 'tsx', 'test/fuzz/run.ts', '--look', '--runs', '200']),
  },
  {
    name: 'fuzz-sides',
    cores: 1,
    run: script(['--import', 'tsx', 'test/fuzz/run.ts', '--sides', '--runs', '300']),
  },
  {
    name: 'playground',
    cores: 1,
    run: inSite(['--import', 'tsx', 'test/site/playground/run.ts']),
  },
  { name: 'stories', cores: 1, run: inSite(['tools/test/stories-test.js']) },
  { name: 'content', cores: 1, folders: ['content'], missing: noContent, run: CHROMIUM },
  {
    name: 'content-firefox',
    cores: 1,
    folders: ['content'],
    missing: () => noContent() ?? noFirefox(),
    run: FIREFOX,
  },
  {
    name: 'content-webkit',
    cores: 1,
    folders: ['content'],
    missing: () => noContent() ?? noWebKit(),
    run: WEBKIT,
  },
];
