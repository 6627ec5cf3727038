import assert from 'node:assert/strict';
import { FoundPoints } from '../../../../physics-core/effects/manifolds/found-points.js';
import { fact } from '../../helpers.js';

// A box that lies askew on another touches with eight corners, and Bullet holds four.

const corner = (i: number): [number, number, number] => [
  Math.cos((i * Math.PI) / 4),
  0,
  Math.sin((i * Math.PI) / 4),
];

/** What is kept of corners that are so deep, micrometres; `before`: the one that came first in the last step. */
function keptOf(depths: readonly number[], before?: number): number[] {
  const points = new FoundPoints();
  points.clear();
  depths.forEach((depth, i) => points.add(...corner(i), 0, 1, 0, -depth * 1e-6, -1));
  if (before !== undefined) points.setBefore(...corner(before));
  points.reduce();
  return [...points.kept.subarray(0, points.keptCount)];
}

fact('of eight corners the deepest is kept, and those that make the widest face with it', () => {
  assert.deepEqual(keptOf([0, 0, 0, 500, 0, 0, 0, 0]), [3, 7, 1, 5]);
});

fact(
  'what trembles by some hundredths of a millimetre rests on the same four of eight corners',
  () => {
    const still = keptOf([20, 0, 0, 0, 0, 0, 0, 0], 0);
    assert.deepEqual(still, [0, 4, 2, 6]);
    assert.deepEqual(keptOf([0, 0, 0, 80, 0, 0, 0, 0], 0), still);
  },
);

fact('a corner that has sunk by more than a tenth of a millimetre comes first', () => {
  assert.deepEqual(keptOf([0, 0, 0, 120, 0, 0, 0, 0], 0), [3, 7, 1, 5]);
});
