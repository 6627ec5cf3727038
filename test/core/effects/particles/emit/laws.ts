import assert from 'node:assert/strict';
import { Draws } from '../../../../../physics-core/effects/particles/emit/draws.js';
import { BIRTH, type Emitter } from '../../../../../physics-core/effects/particles/emit/emitter.js';
import { trianglesOfFace } from '../../../../../physics-core/shapes/polygon.js';
import { tessellate } from '../../../../../physics-core/shapes/tessellate.js';
import type { Mesh } from '../../../../../physics-core/shapes/geometry.js';

export type Vec3 = [number, number, number];

/** Standard deviations of a mean of so many are 0.3 % of that of one. */
export const MANY = 100_000;

/** What the facts allow, as a share of what the law says. */
export const SHARE = 0.01;

/** Births one after the other, `BIRTH` numbers each. */
export class Births {
  readonly all: Float64Array;

  constructor(emitter: Emitter, count = MANY, seed = 1) {
    this.all = new Float64Array(count * BIRTH);
    const draws = new Draws(seed);
    const birth = new Float64Array(BIRTH);
    for (let n = 0; n < count; n++) {
      assert.equal(emitter.emit(draws.of(n), birth), true);
      this.all.set(birth, n * BIRTH);
    }
  }

  /** Mean of what is made of each birth. */
  mean(of: (birth: Float64Array) => number): number {
    let sum = 0;
    this.each((birth) => (sum += of(birth)));
    return sum / (this.all.length / BIRTH);
  }

  each(look: (birth: Float64Array) => void): void {
    for (let at = 0; at < this.all.length; at += BIRTH) look(this.all.subarray(at, at + BIRTH));
  }

  /** Greatest of what is made of each birth. */
  most(of: (birth: Float64Array) => number): number {
    let most = -Infinity;
    this.each((birth) => (most = Math.max(most, of(birth))));
    return most;
  }
}

export const birthsOf = (emitter: Emitter, count?: number, seed?: number): Births =>
  new Births(emitter, count, seed);

export const speedOf = (birth: Float64Array): number => Math.hypot(birth[3]!, birth[4]!, birth[5]!);

/** How far a direction is from length 1. */
export const offUnit = (birth: Float64Array): number => Math.abs(speedOf(birth) - 1);

export function within(actual: number, law: number, allowed: number, what = ''): void {
  assert.ok(Math.abs(actual - law) <= allowed, `${what} is ${actual}, by the law ${law}`);
}

/** Of the places of births: their mean, and the mean products of their coordinates. */
export interface Law {
  mean: number[];
  second: number[][];
}

/** Each with its share of all, which may be below 0 for what is hollow. */
export function mixOf(parts: readonly [share: number, law: Law][]): Law {
  const sum = parts.reduce((all, [share]) => all + share, 0);
  const mix = (of: (law: Law) => number): number =>
    parts.reduce((all, [share, law]) => all + share * of(law), 0) / sum;
  return {
    mean: [0, 1, 2].map((i) => mix((law) => law.mean[i]!)),
    second: [0, 1, 2].map((i) => [0, 1, 2].map((j) => mix((law) => law.second[i]![j]!))),
  };
}

/** Of a segment, triangle or tetrahedron by its corners. */
export function simplexLaw(corners: readonly Vec3[]): Law {
  const count = corners.length;
  const sum = (of: (corner: Vec3) => number): number =>
    corners.reduce((all, corner) => all + of(corner), 0);
  const total = [0, 1, 2].map((i) => sum((corner) => corner[i]!));
  return {
    mean: total.map((value) => value / count),
    second: [0, 1, 2].map((i) =>
      [0, 1, 2].map(
        (j) =>
          (sum((corner) => corner[i]! * corner[j]!) + total[i]! * total[j]!) / count / (count + 1),
      ),
    ),
  };
}

export type Block = [least: Vec3, most: Vec3];

/** Of a box, with its volume. */
export function blockLaw([least, most]: Block): [number, Law] {
  const sides = most.map((value, i) => value - least[i]!);
  const mean = sides.map((side, i) => least[i]! + side / 2);
  const second = mean.map((a, i) =>
    mean.map((b, j) => a * b + (i === j ? (sides[i]! * sides[i]!) / 12 : 0)),
  );
  return [sides.reduce((all, side) => all * side, 1), { mean, second }];
}

/** Means to 1 % of the spread, mean products about them to 1 % of the spreads: a tighter bound than of the law itself. */
export function follow(births: Births, law: Law): void {
  const spread = law.mean.map((mean, i) =>
    Math.sqrt(Math.max(0, law.second[i]![i]! - mean * mean)),
  );
  for (let i = 0; i < 3; i++) {
    within(
      births.mean((b) => b[i]!),
      law.mean[i]!,
      SHARE * spread[i]! + 1e-12,
      `mean ${i}`,
    );
    for (let j = 0; j <= i; j++) {
      const [a, b] = [law.mean[i]!, law.mean[j]!];
      const about = births.mean((birth) => (birth[i]! - a) * (birth[j]! - b));
      const allowed = SHARE * spread[i]! * spread[j]! + 1e-12;
      within(about, law.second[i]![j]! - a * b, allowed, `second ${i} ${j}`);
    }
  }
}

// ---- meshes ------------------------------------------------------------------------------------------------------

export function blockMesh([least, most]: Block): Mesh {
  const mesh = tessellate({ type: 'Box', size: [2, 2, 2] });
  const points = mesh.points.map((value, i) => (value > 0 ? most[i % 3]! : least[i % 3]!));
  return { points, index: mesh.index };
}

export const insideOut = ({ points, index }: Mesh): Mesh => ({
  points,
  index: index.map((_, i) => index[i - (i % 3) + [0, 2, 1][i % 3]!]!),
});

export function joined(...meshes: Mesh[]): Mesh {
  const points: number[] = [];
  const index: number[] = [];
  for (const mesh of meshes) {
    const first = points.length / 3;
    points.push(...mesh.points);
    index.push(...mesh.index.map((i) => i + first));
  }
  return { points, index };
}

/** Each triangle with corners of its own. */
export const apart = ({ points, index }: Mesh): Mesh => ({
  points: index.flatMap((i) => points.slice(3 * i, 3 * i + 3)),
  index: index.map((_, i) => i),
});

export const mapped = ({ points, index }: Mesh, to: (p: Vec3) => Vec3): Mesh => ({
  points: points.flatMap((_, i) => (i % 3 === 0 ? to(points.slice(i, i + 3) as Vec3) : [])),
  index,
});

/** Turned so that no axis stays in its plane, and 10 m along x. */
export const askew = ([x, y, z]: Vec3): Vec3 => [
  (2 * x - y + 2 * z) / 3 + 10,
  (2 * x + 2 * y - z) / 3,
  (-x + 2 * y + 2 * z) / 3,
];

/** A polygon, counter-clockwise, from z = 0 up to a height. */
export function prism(polygon: [number, number][], height: number): Mesh {
  const count = polygon.length;
  const points = [0, height].flatMap((z) => polygon.flatMap(([x, y]) => [x, y, z]));
  const top = trianglesOfFace(
    points,
    polygon.map((_, i) => count + i),
  );
  const index = [...top, ...insideOut({ points, index: top.map((i) => i - count) }).index];
  polygon.forEach((_, i) => {
    const next = (i + 1) % count;
    index.push(i, next, count + next, i, count + next, count + i);
  });
  return { points, index };
}

/** A U: seen from nowhere within are all its places. */
export const U: [number, number][] = [
  [0, 0],
  [3, 0],
  [3, 2],
  [2, 2],
  [2, 1],
  [1, 1],
  [1, 2],
  [0, 2],
];
