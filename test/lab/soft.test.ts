import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { softPicture } from '../../lab/draw/soft-chart.js';
import { softCases } from '../../lab/soft/cases.js';
import { softEngines } from '../../lab/soft/engines.js';
import { levelNames } from '../../lab/soft/levels.js';
import { costOf, frontierOf, oursAt, readSoft, type SoftRow } from '../../lab/soft/numbers.js';
import {
  diagonalsOf,
  massesOf,
  threadsOf,
  trianglesOf,
  type SoftScene,
} from '../../lab/soft/scene.js';
import { withSoft } from '../../lab/soft/text.js';

test('docs/soft.md beside other libraries, and its picture, are those of the numbers', () => {
  const numbers = readSoft();
  const text = readFileSync('docs/soft.md', 'utf8');
  assert.equal(withSoft(text, numbers), text);
  assert.equal(softPicture(numbers), readFileSync('docs/pictures/soft.svg', 'utf8'));
});

test('every scene is measured in every library, ours at each level that it is to have', () => {
  const { cells } = readSoft();
  assert.deepEqual(
    cells.map((cell) => cell.case),
    softCases.map(({ id }) => id),
  );
  for (const [i, cell] of cells.entries()) {
    const { finest, judged } = softCases[i]!;
    const last = finest ? levelNames.indexOf(finest) : levelNames.length - 1;
    for (const level of levelNames.slice(0, last + 1))
      for (const { id } of judged)
        assert.equal(typeof oursAt(cell, level)?.errors[id], 'number', `${cell.case}, ${level}`);
    for (const { id } of softEngines)
      assert.ok(
        cell.rows.some(({ engine }) => engine === id),
        `${cell.case} in ${id}`,
      );
  }
});

const row = (ms: number, off: number | null, step = 1 / 60): SoftRow => ({
  engine: 'jolt',
  level: null,
  step,
  iterations: 1,
  ms,
  errors: { off },
});

test('the best for each cost: what is dearer is truer, and what flew apart is not among them', () => {
  const rows = [row(3, 0.1), row(1, 0.2), row(2, null), row(1, 0.1, 1 / 240), row(0.5, 0.3)];
  const best = frontierOf(rows, { id: 'off', floor: 1e-9 });
  assert.deepEqual(best.map(costOf), [0.5, 1, 3]);
});

test('all libraries are told the same threads, masses and triangles of a sheet', () => {
  const scene: SoftScene = {
    gravity: 1,
    cells: [2, 1],
    points: [0, 1].flatMap((y) => [0, 1, 2].map((x): [number, number, number] => [x, y, 0])),
    mass: 8,
    stretch: 10,
    shear: 3,
    fixed: [],
  };
  assert.deepEqual(massesOf(scene), [1, 2, 1, 1, 2, 1]);
  const threads = threadsOf(scene);
  assert.equal(threads.length, 7);
  assert.deepEqual(threads.find(({ ends }) => ends.join() === '1,4')?.stiffness, 10);
  assert.deepEqual(threads.find(({ ends }) => ends.join() === '0,1')?.stiffness, 5);
  assert.equal(diagonalsOf(scene).length, 4);
  assert.equal(trianglesOf(scene).length, 12);
});
