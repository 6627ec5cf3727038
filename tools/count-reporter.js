import { writeFileSync } from 'node:fs';
import { relative } from 'node:path';

const countSuite = (suite) => {
  const total = { passed: 0, failed: 0 };
  for (const test of suite?.tests ?? []) {
    if (!test.skipped) total[test.passed ? 'passed' : 'failed']++;
  }
  for (const inner of suite?.suites ?? []) add(total, countSuite(inner));
  return total;
};

function add(total, more) {
  total.passed += more.passed;
  total.failed += more.failed;
  return total;
}

function countSession(session) {
  const counts = countSuite(session.testResults);
  // A file that did not load or a page that crashed has no test to blame, but failed all the same.
  if (!session.passed && counts.failed === 0) counts.failed = 1;
  return counts;
}

/**
 * Reporter of Web Test Runner: one line per test file as progress, and at the end the counts as JSON in the
 * file that tools/test.js names.
 */
export function countReporter(outputFile) {
  return {
    reportTestFileResults({ logger, sessionsForTestFile, testFile }) {
      const { passed, failed } = sessionsForTestFile
        .map(countSession)
        .reduce(add, { passed: 0, failed: 0 });
      const name = relative(process.cwd(), testFile);
      logger.log(`${failed ? '✗' : '✓'} ${name}: ${passed} passed, ${failed} failed`);
    },
    stop({ sessions }) {
      if (!outputFile) return;
      const total = sessions.map(countSession).reduce(add, { passed: 0, failed: 0 });
      writeFileSync(outputFile, JSON.stringify(total));
    },
  };
}
