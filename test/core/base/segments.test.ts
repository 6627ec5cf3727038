import { nearestOnSegments } from '../../../physics-core/base/segments.js';
import { test } from 'node:test';
import { below, close, random } from '../helpers.js';

const out = new Float64Array(2);

/** Of both, where they are nearest. */
function shares(p: readonly number[], q: readonly number[]): number[] {
  nearestOnSegments(Float64Array.from(p), 0, 3, Float64Array.from(q), 0, 3, out);
  return [...out];
}

test('segments that cross over are nearest there', () => {
  close(shares([0, 0, 0, 4, 0, 0], [1, 1, -1, 1, 1, 3]), [0.25, 0.25], 1e-15);
});

test('beyond their ends these are nearest', () => {
  close(shares([0, 0, 0, 1, 0, 0], [2, 1, 0, 3, 5, 0]), [1, 0], 1e-15);
  close(shares([0, 0, 0, 0, 0, 0], [-1, 1, 0, 1, 1, 0]), [0, 0.5], 1e-15);
});

test('no other two places are nearer', () => {
  const next = random(3);
  for (let n = 0; n < 200; n++) {
    const [p, q] = [0, 1].map(() => Array.from({ length: 6 }, () => 2 * next() - 1));
    const at = (of: readonly number[], s: number): number[] =>
      [0, 1, 2].map((k) => of[k]! + s * (of[3 + k]! - of[k]!));
    const apart = (s: number, t: number): number => {
      const [a, b] = [at(p!, s), at(q!, t)];
      return Math.hypot(...a.map((x, k) => x - b[k]!));
    };
    const [s, t] = shares(p!, q!);
    const least = apart(s!, t!);
    for (let i = 0; i <= 20; i++)
      for (let j = 0; j <= 20; j++) below(least, apart(i / 20, j / 20) + 1e-12, `${n}`);
  }
});
