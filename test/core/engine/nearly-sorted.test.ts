import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sortNearly } from '../../../physics-core/engine/nearly-sorted.js';

const random = (() => {
  let seed = 7;
  return (below: number): number => {
    seed = (seed * 16807) % 2147483647;
    return seed % below;
  };
})();

const rising = (count: number): number[] => Array.from({ length: count }, (_, i) => 3 * i + 1);

/** As `sortNearly` has them, and as they are in order. */
function both(list: readonly number[]): [number[], number[]] {
  const numbers = Float64Array.from([...list, -5]);
  sortNearly(numbers, list.length, new Float64Array(list.length));
  assert.equal(numbers[list.length], -5, 'what follows stands');
  return [[...numbers.subarray(0, list.length)], list.toSorted((a, b) => a - b)];
}

test('what is in order stays so, and one number or none', () => {
  for (const count of [0, 1, 2, 50]) assert.deepEqual(...both(rising(count)));
});

test('a list of which some went, the last in their place, and to which some came is in order', () => {
  for (let round = 0; round < 200; round++) {
    const list = rising(1 + random(200));
    for (let i = random(20); i > 0 && list.length > 1; i--) {
      const last = list.pop()!;
      if (random(4) > 0) list[random(list.length)] = last;
    }
    for (let i = random(20); i > 0; i--) list.push(3 * random(300) + 2 + i / 64);
    assert.deepEqual(...both(list));
  }
});

test('any order at all, and the wrong way round', () => {
  assert.deepEqual(...both(rising(300).reverse()));
  for (let round = 0; round < 50; round++) {
    const list = rising(150);
    for (let i = list.length - 1; i > 0; i--) {
      const j = random(i + 1);
      [list[i], list[j]] = [list[j]!, list[i]!];
    }
    assert.deepEqual(...both(list));
  }
});
