import assert from 'node:assert/strict';
import { test } from 'node:test';
import { rowOf } from '../../../../physics-core/base/cholesky.js';
import { SparseCholesky } from '../../../../physics-core/solver/matrix/sparse-cholesky.js';
import { SparsePattern } from '../../../../physics-core/solver/matrix/sparse-pattern.js';
import { below, random } from '../../helpers.js';

const next = random(3);

/** Blocks of these sizes, each with some others, as a full matrix too. */
function made(sizes: number[], pairs: [number, number][]) {
  const neighbours = sizes.map(() => new Set<number>());
  for (const [a, b] of pairs) {
    neighbours[a]!.add(b);
    neighbours[b]!.add(a);
  }
  const matrix = new SparseCholesky(new SparsePattern(neighbours), sizes);
  const firsts = sizes.map((_, i) => sizes.slice(0, i).reduce((sum, n) => sum + n, 0));
  const n = firsts.at(-1)! + sizes.at(-1)!;
  const full = Array.from({ length: n }, () => new Array<number>(n).fill(0));
  sizes.forEach((size, i) => {
    for (let r = 0; r < size; r++)
      for (let c = 0; c <= r; c++) {
        const value = r === c ? 10 * sizes.length : next() - 0.5;
        matrix.numbers[matrix.diagonal(i) + rowOf(r) + c] = value;
        full[firsts[i]! + r]![firsts[i]! + c] = full[firsts[i]! + c]![firsts[i]! + r] = value;
      }
  });
  for (const pair of pairs) {
    const { block, straight } = matrix.pattern.between(...pair);
    const [a, b] = straight ? pair : [pair[1], pair[0]];
    for (let r = 0; r < sizes[a]!; r++)
      for (let c = 0; c < sizes[b]!; c++) {
        const value = next() - 0.5;
        matrix.numbers[matrix.block(block) + r * sizes[b]! + c] = value;
        full[firsts[a]! + r]![firsts[b]! + c] = full[firsts[b]! + c]![firsts[a]! + r] = value;
      }
  }
  return { matrix, full, firsts, sizes };
}

const graphs: Record<string, [number[], [number, number][]]> = {
  'one block': [[3], []],
  'blocks apart, one of them empty': [[2, 0, 3], []],
  'a ring of blocks of unlike sizes': [
    [1, 5, 3, 2, 6],
    [
      [0, 1],
      [1, 2],
      [2, 3],
      [3, 4],
      [4, 0],
    ],
  ],
  'a hub': [[3, 1, 2, 3, 4], [1, 2, 3, 4].map((i) => [0, i] as [number, number])],
  'a net': [
    Array.from({ length: 36 }, (_, i) => 1 + (i % 4)),
    Array.from({ length: 36 }, (_, i) => i).flatMap((i) => [
      ...(i % 6 < 5 ? [[i, i + 1] as [number, number]] : []),
      ...(i < 30 ? [[i, i + 6] as [number, number]] : []),
    ]),
  ],
};

for (const [name, [sizes, pairs]] of Object.entries(graphs))
  void test(`${name}: the solution solves the full matrix`, () => {
    const { matrix, full, firsts } = made(sizes, pairs);
    const b = full.map(() => next() - 0.5);
    sizes.forEach((size, i) => {
      for (let r = 0; r < size; r++) matrix.vector[matrix.at(i) + r] = b[firsts[i]! + r]!;
    });
    assert.ok(matrix.factor());
    matrix.solve();
    const x: number[] = [];
    sizes.forEach((size, i) => {
      for (let r = 0; r < size; r++) x.push(matrix.vector[matrix.at(i) + r]!);
    });
    full.forEach((row, i) =>
      below(Math.abs(row.reduce((sum, value, k) => sum + value * x[k]!, 0) - b[i]!), 1e-12),
    );
  });

void test('a net of 20 by 20 fills in little', () => {
  const neighbours = Array.from({ length: 400 }, () => new Set<number>());
  for (let i = 0; i < 400; i++)
    for (const k of [i % 20 < 19 ? i + 1 : -1, i + 20])
      if (k >= 0 && k < 400) neighbours[i]!.add(k) && neighbours[k]!.add(i);
  // Row by row it would be a band of 20: 8000 blocks.
  below(new SparsePattern(neighbours).rows.length, 3500, 'blocks');
});

void test('what is not positive definite has no factor', () => {
  const { matrix } = made([2, 2], [[0, 1]]);
  matrix.numbers[matrix.diagonal(0)] = -1;
  assert.equal(matrix.factor(), false);
});
