import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SIZE, SparseCholesky } from '../../../../physics-core/solver/matrix/block-cholesky.js';
import { below } from '../../helpers.js';
import { fullOf, next, some } from '../rows/contacts.js';

// The sparse factor of blocks of six against elimination in the full matrix.

/** By Gauss, with pivots. */
function solved(full: readonly number[][], b: readonly number[]): number[] {
  const m = full.map((row, i) => [...row, b[i]!]);
  const n = m.length;
  for (let k = 0; k < n; k++) {
    let best = k;
    for (let i = k; i < n; i++) if (Math.abs(m[i]![k]!) > Math.abs(m[best]![k]!)) best = i;
    [m[k], m[best]] = [m[best]!, m[k]!];
    for (let i = k + 1; i < n; i++) {
      const share = m[i]![k]! / m[k]![k]!;
      for (let j = k; j <= n; j++) m[i]![j]! -= share * m[k]![j]!;
    }
  }
  const x = new Array<number>(n).fill(0);
  for (let k = n - 1; k >= 0; k--) {
    let sum = m[k]![n]!;
    for (let j = k + 1; j < n; j++) sum -= m[k]![j]! * x[j]!;
    x[k] = sum / m[k]![k]!;
  }
  return x;
}

const range = (n: number): number[] => Array.from({ length: n }, (_, i) => i);

const GRAPHS: Record<string, [bodies: number, pairs: [number, number][]]> = {
  'one body': [1, []],
  'bodies apart': [3, []],
  'a stack': [8, range(7).map((i) => [i, i + 1])],
  'a ring': [6, range(6).map((i) => [i, (i + 1) % 6])],
  'a hub': [7, range(6).map((i) => [0, i + 1])],
  'a wall': [
    20,
    range(20).flatMap((i): [number, number][] => [
      ...(i % 5 < 4 ? [[i, i + 1] as [number, number]] : []),
      ...(i < 15 ? [[i + 5, i] as [number, number]] : []),
    ]),
  ],
  'all with all': [5, range(5).flatMap((i) => range(i).map((k): [number, number] => [i, k]))],
};

/** Random symmetric matrices, positive definite by their diagonals. */
function fill(
  matrix: SparseCholesky,
  bodies: number,
  pairs: readonly [number, number][],
  changing: readonly number[] = [],
): void {
  matrix.begin(bodies);
  for (const [a, b] of pairs) matrix.connect(a, b);
  for (const i of changing) matrix.changes(i);
  assert.ok(matrix.analyse(1e6));
  matrix.clear();
  for (let i = 0; i < bodies; i++) {
    const at = matrix.diagonal(i);
    for (let r = 0; r < SIZE; r++)
      for (let s = 0; s <= r; s++) {
        const value = r === s ? 6 * bodies + 10 * next() : some();
        matrix.values[at + r * SIZE + s] = matrix.values[at + s * SIZE + r] = value;
      }
  }
  for (const pair of pairs) {
    const between = matrix.between(...pair);
    const at = between >= 0 ? between : -1 - between;
    for (let k = 0; k < SIZE * SIZE; k++) matrix.values[at + k] = some();
  }
}

// One matrix for all, as in a world: nothing of an earlier one may be left.
const shared = new SparseCholesky();

for (const [name, [bodies, pairs]] of Object.entries(GRAPHS))
  void test(`${name}: the solution is that of the full matrix`, () => {
    for (let run = 0; run < 3; run++) {
      fill(shared, bodies, pairs);
      const full = fullOf(shared, bodies, pairs);
      const b = range(SIZE * bodies).map(some);
      const x = Float64Array.from(b);
      assert.ok(shared.factorConstant() && shared.factor());
      shared.solve(x);
      solved(full, b).forEach((value, i) => below(Math.abs(value - x[i]!), 1e-10));
    }
  });

for (const [name, [bodies, pairs]] of Object.entries(GRAPHS))
  void test(`${name}: what changes is factored anew, by itself`, () => {
    const changing = range(bodies).filter((i) => i % 3 === 0);
    fill(shared, bodies, pairs, changing);
    const full = fullOf(shared, bodies, pairs);
    assert.ok(shared.factorConstant());
    for (let run = 0; run < 3; run++) {
      shared.restore();
      const more = changing.map(() => 10 * next());
      changing.forEach((i, k) => {
        for (let r = 0; r < SIZE; r++)
          shared.values[shared.diagonal(i) + r * SIZE + r]! += more[k]!;
      });
      const changed = full.map((row) => [...row]);
      changing.forEach((i, k) => {
        for (let r = i * SIZE; r < (i + 1) * SIZE; r++) changed[r]![r]! += more[k]!;
      });
      const b = range(SIZE * bodies).map(some);
      const x = Float64Array.from(b);
      assert.ok(shared.factor());
      shared.solve(x);
      solved(changed, b).forEach((value, i) => below(Math.abs(value - x[i]!), 1e-10));
    }
  });

void test('what costs more than it may is not analysed, and what is not positive definite has no factor', () => {
  const matrix = new SparseCholesky();
  matrix.begin(5);
  for (const i of range(4)) matrix.connect(i, i + 1);
  assert.equal(matrix.analyse(5), false);
  fill(matrix, 2, [[0, 1]]);
  matrix.values[matrix.diagonal(1)] = -1;
  assert.equal(matrix.factorConstant(), false);
  fill(matrix, 2, [[0, 1]], [1]);
  assert.ok(matrix.factorConstant());
  matrix.values[matrix.diagonal(1)] = -1;
  assert.equal(matrix.factor(), false);
});

void test('a stack fills in nothing: its cost grows with its height', () => {
  const products = [10, 20, 40].map((count) => {
    const matrix = new SparseCholesky();
    matrix.begin(count);
    for (const i of range(count - 1)) matrix.connect(i, i + 1);
    assert.ok(matrix.analyse(1e6));
    return matrix.products;
  });
  below(products[2]! / products[1]!, 2.1);
  below(products[1]! / products[0]!, 2.2);
});
