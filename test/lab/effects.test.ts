import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { effectsPicture } from '../../lab/draw/effects-chart.js';
import { additions } from '../../lab/effects/additions.js';
import { readEffects } from '../../lab/effects/numbers.js';
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
