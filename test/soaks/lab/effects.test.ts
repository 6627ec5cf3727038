import assert from 'node:assert/strict';
import { test } from 'node:test';
import { estimate } from '../../../lab/statistics.js';

test('the interval of a median is the same each time, and holds the true one nineteen times of twenty', () => {
  let state = 7;
  const next = (): number => (state = (state * 16807) % 2147483647) / 2147483647;
  const sample = (): number[] => Array.from({ length: 25 }, next);
  const once = sample();
  assert.deepEqual(estimate(once), estimate(once));
  // Even between 0 and 1: the true median is a half.
  const held = Array.from({ length: 200 }, () => estimate(sample())).filter(
    ({ low, high }) => low <= 0.5 && high >= 0.5,
  ).length;
  // 190 would be exact; 184 are measured: with 25 numbers the bootstrap is a little narrow.
  assert.ok(held >= 175 && held <= 198, `${held} of 200`);
});
