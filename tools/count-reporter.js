import { writeFileSync } from 'node:fs';
import { relative } from 'node:path';

const none = () => ({ passed: 0, failed: 0, skipped: 0 });

const countSuite = (suite) => {
  const total = none();
  for (const test of suite?.tests ?? []) {
    total[test.skipped ? 'skipped' : test.passed ? 'passed' : 'failed']++;
  }
  for (const inner of suite?.suites ?? []) add(total, countSuite(inner));
  return total;
};

function add(total, more) {
  for (const key of Object.keys(total)) total[key] += more[key];
  return total;
}

function countSession(session) {
  const counts = countSuite(session.testResults);
  // A file that did not load or a page that crashed has no test to blame, but failed all the same.
  if (!session.passed && counts.failed === 0) counts.failed = 1;
  return counts;
}

/**
 * Reporter of Web Test Runner: one line per test file as progress (seconds since the one before), and at the end the counts as JSON in the
 * file that tools/test.js names.
 */
export function countReporter(outputFile, sourceOf) {
  let last = Date.now();
  return {
    reportTestFileResults({ logger, sessionsForTestFile, testFile }) {
      const { passed, failed, skipped } = sessionsForTestFile.map(countSession).reduce(add, none());
      const name = sourceOf(relative(process.cwd(), testFile));
      const left = skipped ? `, ${skipped} skipped` : '';
      const time = ((Date.now() - last) / 1000).toFixed(1);
      last = Date.now();
      logger.log(
        `${failed ? '✗' : '✓'} ${name}: ${passed} passed, ${failed} failed${left}, ${time} s`,
      );
    },
    stop({ sessions }) {
      if (!outputFile) return;
      const total = sessions.map(countSession).reduce(add, none());
      writeFileSync(outputFile, JSON.stringify(total));
    },
  };
}
