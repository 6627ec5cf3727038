import { writeFileSync } from 'node:fs';
import { relative } from 'node:path';

export const none = () => ({ passed: 0, failed: 0, skipped: 0 });

const countSuite = (suite) => {
  const total = none();
  for (const test of suite?.tests ?? []) {
    total[test.skipped ? 'skipped' : test.passed ? 'passed' : 'failed']++;
  }
  for (const inner of suite?.suites ?? []) add(total, countSuite(inner));
  return total;
};

export function add(total, more) {
  for (const key of Object.keys(total)) total[key] += more[key];
  return total;
}

/** Of a suite: each test that failed, by its whole name, and why. */
const faultsOf = (suite, above = '') => [
  ...(suite?.tests ?? [])
    .filter(({ passed, skipped }) => !passed && !skipped)
    .map(({ name, error }) => `${above}${name}: ${error?.message ?? 'no error'}`),
  ...(suite?.suites ?? []).flatMap((inner) => faultsOf(inner, `${above}${inner.name} › `)),
];

function countSession(session) {
  const counts = countSuite(session.testResults);
  // A file that did not load or a page that crashed has no test to blame, but failed all the same.
  if (!session.passed && counts.failed === 0) counts.failed = 1;
  return counts;
}

/**
 * Reporter of Web Test Runner: one line per test file as progress (seconds since the one before), and the counts by file
 * and what failed, as JSON in the file that tools/test/test.js names: after each, so that something is known where a browser
 * takes the runner along. `ended` says that it came to its end.
 */
export function countReporter(outputFile, sourceOf) {
  const files = {};
  let last = Date.now();
  const write = (ended) => {
    if (outputFile) writeFileSync(outputFile, JSON.stringify({ ended, files }));
  };
  return {
    reportTestFileResults({ logger, sessionsForTestFile, testFile }) {
      const file = relative(process.cwd(), testFile);
      const counts = sessionsForTestFile.map(countSession).reduce(add, none());
      const { passed, failed, skipped } = counts;
      const faults = sessionsForTestFile
        .flatMap(({ testResults, errors }) => [
          ...faultsOf(testResults),
          ...errors.map(({ message }) => message),
        ])
        .map((fault) => `${sourceOf(file)}: ${fault}`);
      files[file] = { ...counts, faults };
      const left = skipped ? `, ${skipped} skipped` : '';
      const time = ((Date.now() - last) / 1000).toFixed(1);
      last = Date.now();
      logger.log(
        `${failed ? '✗' : '✓'} ${sourceOf(file)}: ${passed} passed, ${failed} failed${left}, ${time} s`,
      );
      write(false);
    },
    stop: () => write(true),
  };
}
