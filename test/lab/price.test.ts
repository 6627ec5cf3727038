import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import type { CaseScene } from '../../lab/case.js';
import { pricePicture } from '../../lab/draw/price-chart.js';
import { markdownOf } from '../../lab/draw/table.js';
import { engines, running } from '../../lab/price/engines.js';
import type { PriceCell, Side } from '../../lab/price/measure.js';
import { cellOf, readPrice, withCell } from '../../lab/price/numbers.js';
import { overlapIn } from '../../lab/price/overlap.js';
import { box, touching } from '../../lab/price/scene.js';
import { priceScenes } from '../../lab/price/scenes/index.js';
import { costTable, hitchTable } from '../../lab/price/tables.js';
import { withPrice } from '../../lab/price/text.js';
import { shareOf } from '../../lab/statistics.js';

test('the share of one sum of another holds what all pairs together say', () => {
  const even = shareOf([
    [2, 1],
    [4, 2],
    [6, 3],
  ]);
  assert.deepEqual(even, { mean: 2, low: 2, high: 2 });
  const pairs = Array.from({ length: 15 }, (_, i): [number, number] => [1 + (i % 3), 1]);
  const { mean, low, high } = shareOf(pairs);
  assert.equal(mean, 2);
  assert.ok(low < 2 && high > 2 && high - low < 1, `${low} – ${high}`);
});

const side = (median: number): Side => ({
  median,
  mean: median,
  first: 5 * median,
  worst: 3 * median,
  toAmmo: { median: { median, low: 0.5, high: 9 }, mean: { mean: 2 * median, low: 1, high: 8 } },
  errors: { overlap: 1e-3, gap: null, energy: null },
});

const cell = (sides: PriceCell['sides'], level = 'standard'): PriceCell => ({
  scene: 'tumbling-10',
  level,
  step: 1 / 120,
  turns: 20,
  bodies: 10,
  joints: 0,
  machine: 'one',
  date: '2026-01-01',
  load: 1,
  sides,
});

test('tables have the ratio of each engine with its interval, and what one lacks in its place', () => {
  const numbers = { cells: [cell({ ours: side(4), ammo: side(1), rapier: 'meshes' })] };
  assert.deepEqual(costTable(numbers, 'standard').rows, [
    ['10 boxes tumbling in a drum', '1', '4 (0.5 – 9)', '8 (1 – 8)', 'no meshes', '–'],
  ]);
  assert.deepEqual(hitchTable(numbers, 'standard').rows[0]!.slice(1), [
    ...['5', '5', '–', '–'],
    ...['3', '3', '–', '–'],
  ]);
  assert.match(markdownOf(costTable(numbers, 'standard')), /^\| scene \| Ammo, ms \| ours : Ammo/);
});

test('a cell measured anew takes the place of that of before, and levels stay in their order', () => {
  const old = { cells: [cell({}, 'game'), cell({ ours: side(1) }), cell({}, 'reference')] };
  const { cells } = withCell(old, cell({ ours: side(2) }));
  assert.deepEqual(
    cells.map(({ level }) => level),
    ['game', 'standard', 'reference'],
  );
  assert.deepEqual(cells[1]!.sides, { ours: side(2) });
});

test('overlap is how deep bodies are in each other by their places, with a turn and without', async () => {
  const stack = (gap: number, turn: number): CaseScene =>
    touching([
      { name: 'below', fixed: true, shape: box(2, 1, 2) },
      {
        name: 'above',
        position: [0, 1 + gap, 0],
        shape: box(1, 1, 1),
        orientation: [0, 1, 0, turn],
      },
    ]);
  for (const turn of [0, 0.5]) {
    const depth = async (gap: number) => {
      const scene = stack(gap, turn);
      const made = await running(engines[0]!, scene, 'standard');
      if (typeof made === 'string') throw new Error(made);
      const found = await overlapIn(scene, made);
      made.destroy();
      return found;
    };
    assert.ok(Math.abs((await depth(-0.01)) - 0.01) < 1e-5);
    assert.equal(await depth(0.1), 0);
  }
});

test('what is measured has full sizes, and at least 15 turns of each engine', () => {
  const numbers = readPrice();
  for (const { id } of priceScenes)
    for (const level of ['game', 'standard'])
      assert.ok(cellOf(numbers, id, level), `${id} at ${level}`);
  for (const { scene, turns, sides } of numbers.cells) {
    assert.ok(turns >= 15, scene);
    for (const { toAmmo } of Object.values(sides).filter((one) => typeof one !== 'string'))
      assert.ok(!toAmmo || (toAmmo.median.low <= toAmmo.median.high && toAmmo.mean.low > 0));
  }
});

test('docs/price.md and its picture are those of the numbers', () => {
  const numbers = readPrice();
  const text = readFileSync('docs/price.md', 'utf8');
  assert.equal(withPrice(text, numbers), text);
  assert.equal(pricePicture(numbers), readFileSync('docs/pictures/price.svg', 'utf8'));
});
