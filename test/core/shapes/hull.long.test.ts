import { dot, quaternionOf, rotate } from '../../../physics-core/base/math.js';
import { hullOf } from '../../../physics-core/shapes/hull.js';
import assert from 'node:assert/strict';
import { fact, type Vec3 } from '../helpers.js';

/** A cube of 2 m as `n` by `n` by `n` points. */
const grid = (n: number): Vec3[] =>
  Array.from({ length: n ** 3 }, (_, i) => {
    const at = [i % n, Math.floor(i / n) % n, Math.floor(i / n ** 2)];
    return at.map((value) => (2 * value) / (n - 1) - 1) as Vec3;
  });

/** Evenly over a sphere of 1 m, along a spiral. */
const spiral = (n: number): Vec3[] =>
  Array.from({ length: n }, (_, i) => {
    const y = 1 - (2 * i + 1) / n;
    const angle = i * Math.PI * (3 - Math.sqrt(5));
    return [Math.sqrt(1 - y * y) * Math.cos(angle), y, Math.sqrt(1 - y * y) * Math.sin(angle)];
  });

const cornersOf = (points: Vec3[]): number[] | undefined => hullOf(points.flat())?.corners;

const turned = (points: Vec3[], k: number): Vec3[] =>
  points.map((p) => rotate(quaternionOf([Math.sin(k), Math.cos(k), 0.5, k]), p));

const farthest = (points: Vec3[], way: Vec3): number =>
  Math.max(...points.map((point) => dot(point, way)));

fact('of ten thousand points of a box only its eight corners stand out', () => {
  const points = grid(22);
  const corners = cornersOf(points)!;
  assert.deepEqual(
    corners,
    [...points.keys()].filter((i) => points[i]!.every((value) => Math.abs(value) === 1)),
  );
});

fact('of ten thousand points of a sphere all stand out, and none of those inside it', () => {
  const points = [...spiral(10_000), ...spiral(1000).map((p) => p.map((x) => 0.99 * x) as Vec3)];
  assert.deepEqual(cornersOf(points), [...Array(10_000).keys()]);
});

fact('points that stand there twice stand out once', () => {
  const points = grid(5);
  assert.equal(cornersOf([...points, ...points, ...points])!.length, 8);
});

fact('with six decimals, or in single precision far away, no corner gets lost', () => {
  const faces = grid(7).filter((p) => p.some((value) => Math.abs(value) === 1));
  for (let k = 0; k < 100; k++)
    for (const round of [(x: number) => Number(x.toFixed(6)), (x: number) => Math.fround(x + 10)]) {
      const points = turned(faces, k).map((p) => p.map(round) as Vec3);
      const corners = cornersOf(points)!.map((i) => points[i]!);
      for (const way of spiral(50)) assert.equal(farthest(corners, way), farthest(points, way));
    }
});

fact('a hull is the same whatever its size', () => {
  for (const size of [1e-30, 1e-6, 1e6, 1e30]) {
    assert.equal(cornersOf(spiral(200).map((p) => p.map((x) => size * x) as Vec3))!.length, 200);
  }
});

fact('points in one plane, on one line, at one place or fewer than four have no hull', () => {
  const flat = grid(5).filter(([x]) => x === 1);
  const line = Array.from({ length: 20 }, (_, i): Vec3 => [i, 2 * i, 3 * i]);
  const place = Array.from({ length: 20 }, (): Vec3 => [1, 2, 3]);
  for (const points of [flat, line, place, spiral(3), spiral(1), []])
    assert.equal(cornersOf(points), undefined);
});
