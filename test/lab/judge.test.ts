import assert from 'node:assert/strict';
import { test } from 'node:test';
import { floorOf } from '../../lab/case.js';
import { duel, errorAt, hardestDuel, isBehind } from '../../lab/draw/judge.js';
import { thrown, row } from './runs.js';

test('between two runs the error in a given time lies on the line of the logarithms', () => {
  const sweep = [row(1, 1), row(4, 0.01), row(2, 3)];
  assert.ok(
    Math.abs(errorAt(2, sweep) - 0.1) < 1e-12,
    'the run that is dearer and worse does not count',
  );
  assert.equal(errorAt(0.5, sweep), 1);
  assert.equal(errorAt(9, sweep), 0.01);
});

test('a duel counts errors under the floor as at it', () => {
  const mine = (error: number) => row(4, error, { engine: 'ours', level: 'standard' });
  const floor = floorOf(thrown);
  assert.equal(duel(thrown, 'ammo', [mine(0.02), row(4, 0.2)])!.factor, 10);
  assert.equal(duel(thrown, 'ammo', [mine(floor / 1000), row(4, 5 * floor)])!.factor, 5);
  assert.equal(duel(thrown, 'ammo', [mine(0.02)])!.factor, null);
});

test('standard is judged by whoever of raw Ammo, Rapier and Jolt comes nearest in the same time', () => {
  const floor = floorOf(thrown);
  const rows = [
    row(4, 5 * floor, { engine: 'ours', level: 'standard' }),
    row(4, 20 * floor),
    row(4, 10 * floor, { engine: 'rapier' }),
    row(9, 2 * floor, { engine: 'jolt' }),
    row(4, 12 * floor, { engine: 'jolt' }),
    row(4, floor, { engine: 'cannon' }),
  ];
  const found = hardestDuel(thrown, rows)!;
  assert.equal(found.engine, 'rapier');
  assert.equal(found.factor, 2);
  assert.ok(!isBehind(found));
  const nearer = hardestDuel(thrown, [...rows, row(4, 2 * floor, { engine: 'jolt' })])!;
  assert.ok(isBehind(nearer));
  const none = hardestDuel(thrown, [rows[0]!])!;
  assert.ok(none.theirs === null && !isBehind(none));
});
