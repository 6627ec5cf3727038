import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { effectsPicture } from '../../lab/draw/effects-chart.js';
import { additions } from '../../lab/effects/additions.js';
import { readEffects } from '../../lab/effects/numbers.js';
import { estimate } from '../../lab/statistics.js';
import { allEffects } from '../../physics-core/effects/all.js';

test('the chart of effects has each one that comes by itself, once', () => {
  const alone = allEffects.filter((effect) => !effect.with).map(({ name }) => name);
  assert.deepEqual(additions.map(({ effect }) => effect).sort(), alone.sort());
  const measured = readEffects().costs.map(({ effect }) => effect);
  assert.deepEqual(
    measured,
    additions.map(({ effect }) => effect),
  );
});

test('its picture is drawn from the numbers of the report', () => {
  assert.equal(effectsPicture(readEffects()), readFileSync('docs/pictures/effects.svg', 'utf8'));
});

test('its numbers stand on at least 15 pairs, and their intervals hold them', () => {
  const { pairs, costs } = readEffects();
  assert.ok(pairs >= 15);
  for (const { effect, ms } of costs)
    assert.ok(ms.low <= ms.median && ms.median <= ms.high, `${effect} ${JSON.stringify(ms)}`);
});

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
