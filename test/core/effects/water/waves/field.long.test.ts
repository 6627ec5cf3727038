import assert from 'node:assert/strict';
import { test } from 'node:test';
import { WaveField } from '../../../../../physics-core/effects/water/waves/field.js';
import { inRoots } from '../../../../in-roots.js';

const G = 9.8;

interface Pool {
  columns?: number;
  rows?: number;
  width?: number;
  length?: number;
  depth?: number;
  open?: boolean;
  damping?: number;
}

function pool({ open = false, damping = 0, depth = 2, ...size }: Pool = {}): WaveField {
  const field = new WaveField({ columns: 64, rows: 64, width: 10, length: 10, ...size });
  field.conditions = { depth, gravity: G, open, damping };
  return field;
}

/** Fills heights by what is at each cell's middle, from the field's own. */
function raise(field: WaveField, height: (x: number, z: number) => number): void {
  const { columns, rows, cellWidth, cellLength, width, length } = field;
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++)
      field.heights[j * columns + i] = height(
        (i + 0.5) * cellWidth - width / 2,
        (j + 0.5) * cellLength - length / 2,
      );
}

const hump = (width: number) => (x: number, z: number) =>
  0.1 * Math.exp(-(x * x + z * z) / (width * width));

function energy({ heights, alongWidth, alongLength, conditions }: WaveField): number {
  const { gravity, depth } = conditions;
  const square = (all: Float64Array) => all.reduce((sum, x) => sum + x * x, 0);
  return (gravity * square(heights) + (square(alongWidth) + square(alongLength)) / depth) / 2;
}

/** Seconds from one crossing of zero upward of what is shown to the one so many later, mean of one. */
function period(field: WaveField, dt: number, show: () => number, swings: number): number {
  const crossings: number[] = [];
  let before = show();
  for (let step = 1; crossings.length <= swings; step++) {
    field.step(dt);
    const now = show();
    if (before < 0 && now >= 0) crossings.push((step - now / (now - before)) * dt);
    before = now;
  }
  return (crossings.at(-1)! - crossings[0]!) / swings;
}

for (const [side, columns, rows] of [
  ['width', 64, 1],
  ['width', 128, 128],
  ['length', 16, 64],
] as const)
  for (const dt of [1 / 60, 1 / 120, 1 / 960])
    test(`a seiche along the ${side} of ${columns} × ${rows} cells swings by 2L/√(gH), step ${dt}`, () => {
      const field = pool({ columns, rows });
      raise(field, (x, z) => 0.1 * Math.sin((Math.PI * (side === 'width' ? x : z)) / 10));
      const expected = 20 / Math.sqrt(G * 2);
      const measured = period(field, dt, () => field.heights[0]!, 10);
      assert.ok(Math.abs(measured / expected - 1) < 5e-4, `${measured / expected - 1}`);
    });

test('waves go at √(gH)', () => {
  const dt = 1 / 120;
  for (const depth of [0.5, 2]) {
    const field = pool({ columns: 256, rows: 1, width: 40, length: 1, depth });
    raise(field, (x) => 0.1 * Math.exp(-x * x));
    /** The middle of what goes to the right, weighed by how high it is. */
    const gone = () => {
      let sum = 0;
      let moment = 0;
      for (let i = 128; i < 256; i++) {
        sum += field.heights[i]!;
        moment += field.heights[i]! * ((i + 0.5) * field.cellWidth);
      }
      return moment / sum;
    };
    const steps = Math.round(6 / Math.sqrt(G * depth) / dt);
    for (let i = 0; i < steps; i++) field.step(dt);
    const before = gone();
    for (let i = 0; i < steps; i++) field.step(dt);
    const speed = (gone() - before) / (steps * dt);
    assert.ok(Math.abs(speed / Math.sqrt(G * depth) - 1) < 1e-4, `${speed}`);
  }
});

test('the volume is kept to rounding, and the energy of what swings between walls is as it was', () => {
  for (const dt of [1 / 60, 1 / 960]) {
    const field = pool();
    raise(field, hump(1));
    const before = energy(field);
    const { level } = field;
    for (let i = 0; i < 30 / dt; i++) {
      field.step(dt);
      const share = energy(field) / before;
      assert.ok(share > 0.9 && share < 1.1, `${share}`);
    }
    assert.ok(Math.abs(field.level / level - 1) < 1e-12);
  }
});

test('damping takes half of itself from the height of what swings in a second', () => {
  const field = pool({ columns: 64, rows: 1, damping: 0.2 });
  raise(field, (x) => 0.1 * Math.sin((Math.PI * x) / 10));
  const before = energy(field);
  for (let i = 0; i < 1200; i++) field.step(1 / 120);
  assert.ok(Math.abs(Math.log(energy(field) / before) / -2 - 1) < 0.05);
});

test('open edges let a hump out: less than a hundredth of its energy stays, and then less', () => {
  for (const dt of [1 / 60, 1 / 120, 1 / 960]) {
    const field = pool({ open: true });
    raise(field, hump(1));
    const before = energy(field);
    for (let i = 0; i < 3 / dt; i++) field.step(dt);
    assert.ok(energy(field) / before < 0.01);
    for (let i = 0; i < 6 / dt; i++) field.step(dt);
    assert.ok(energy(field) / before < 1e-6);
  }
});

test('steps of any length hold: of long ones it makes several', () => {
  const field = pool({ columns: 256, rows: 256, width: 4, length: 4 });
  raise(field, hump(0.5));
  for (let i = 0; i < 20; i++) field.step(0.1);
  assert.ok(field.heights.every((height) => Math.abs(height) < 0.1));
});

test('a step of 128 × 128 cells takes the time of a few roots for each of them', () => {
  const field = pool({ columns: 128, rows: 128 });
  raise(field, hump(1));
  for (let i = 0; i < 200; i++) field.step(1 / 120);
  const roots = inRoots(() => field.step(1 / 120), 128 * 128);
  assert.ok(roots < 10, `${roots}`);
});
