import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Slabs } from '../../../../../physics-core/effects/particles/collide/slabs.js';
import { random } from '../../../helpers.js';

const next = random(5);
const either = (most: number): number => (2 * next() - 1) * most;

function boxAt(middle: number[], half: number): number[] {
  return [...middle.map((value) => value - half), ...middle.map((value) => value + half)];
}

const meets = (a: ArrayLike<number>, b: ArrayLike<number>): boolean =>
  [0, 1, 2].every((k) => a[k]! <= b[3 + k]! && a[3 + k]! >= b[k]!);

function filled(boxes: number[][]): Slabs {
  const slabs = new Slabs();
  slabs.fill(Float64Array.from(boxes.flat()), boxes.length);
  return slabs;
}

test('the boxes that are found are those that meet, wherever boxes lie and however large they are', () => {
  for (let round = 0; round < 50; round++) {
    const wide = round % 2 ? 2 : 40;
    const boxes = Array.from({ length: 1 + 3 * round }, (_, i) =>
      boxAt([either(wide), either(wide / 10), either(wide)], i % 20 ? 0.5 : 100),
    );
    if (round % 3 === 0) boxes.push(boxAt([either(1), -1e6, 0], 1), boxAt([0, 0, 0], Infinity));
    const slabs = filled(boxes);
    const found = new Int32Array(boxes.length);
    for (let tries = 0; tries < 100; tries++) {
      const box = Float64Array.from(boxAt([either(50), either(6), either(50)], 0.1 + next()));
      const count = slabs.near(box, found);
      const right = boxes.flatMap((each, i) => (meets(each, box) ? [i] : []));
      assert.deepEqual(
        [...found.subarray(0, count)].sort((a, b) => a - b),
        right,
      );
      if (right.length > 0) assert.ok(slabs.any(box));
    }
  }
});

test('what flies above a layer of boxes on the ground is near none of them', () => {
  const layer = Array.from({ length: 50 }, (_, i) => boxAt([2 * (i % 10), 0.5, i / 5], 0.5));
  const slabs = filled([[-20, -1, -20, 20, 0, 20], ...layer]);
  for (let i = 0; i < 100; i++) {
    const above = boxAt([either(20), 1.3 + 9 * next(), either(20)], 0.1);
    assert.equal(slabs.any(Float64Array.from(above)), false, String(above));
  }
});

test('without boxes nothing is near', () => {
  assert.equal(filled([]).any(Float64Array.from([0, 0, 0, 1, 1, 1])), false);
});
