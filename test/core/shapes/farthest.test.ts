import assert from 'node:assert/strict';
import { Farthest } from '../../../physics-core/shapes/forms/farthest.js';
import { fact, random } from '../helpers.js';

const next = random(11);
const number = (): number => 2 * next() - 1;

const gridAt = (i: number, axis: number): number => (Math.floor(i / 5 ** axis) % 5) - 2;

/** On a ball, in a ball far from the origin, and on a grid, where many are equally far. */
const clouds: readonly (readonly [string, Float64Array])[] = [
  ['on a ball', cloud(200, (point) => point.map((x) => x / Math.hypot(...point)))],
  ['beside the origin', cloud(60, (point) => point.map((x) => 5 + 0.1 * x))],
  ['of a grid', Float64Array.from({ length: 3 * 125 }, (_, i) => gridAt(Math.floor(i / 3), i % 3))],
  ['in a plane', cloud(40, ([x, y]) => [x!, y!, 0])],
];

function cloud(count: number, place: (point: number[]) => number[]): Float64Array {
  return Float64Array.from(
    Array.from({ length: count }, () => place([number(), number(), number()])).flat(),
  );
}

function* directions(): Generator<readonly [number, number, number]> {
  for (const x of [-1, -0.5, 0, 0.5, 1])
    for (const y of [-1, -0.5, 0, 0.5, 1])
      for (const z of [-1, -0.5, 0, 0.5, 1]) if (x || y || z) yield [x, y, z];
  for (let i = 0; i < 3000; i++) yield [number(), number(), number()];
}

/** By looking at each. */
function farthestOf(points: Float64Array, [x, y, z]: readonly number[]): number {
  let most = -Infinity;
  let found = 0;
  for (let i = 0; i < points.length; i += 3) {
    const along = points[i]! * x! + points[i + 1]! * y! + points[i + 2]! * z!;
    if (along > most) {
      most = along;
      found = i / 3;
    }
  }
  return found;
}

for (const [name, points] of clouds)
  fact(`of points ${name} the farthest along a direction is the first of those that are`, () => {
    const farthest = new Farthest(points);
    for (const direction of directions())
      assert.equal(farthest.along(...direction), farthestOf(points, direction), `${direction}`);
  });
