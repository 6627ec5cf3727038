import { test } from 'node:test';
import { ballCut, EllipsoidCut } from '../../../../physics-core/shapes/cut/ball.js';
import { BELOW, CUT, type Cuttable } from '../../../../physics-core/shapes/cut/cut.js';
import { FacetCut } from '../../../../physics-core/shapes/cut/facets.js';
import { FrustumCut } from '../../../../physics-core/shapes/cut/frustum.js';
import { cutOf } from '../../../../physics-core/shapes/cut/of-outline.js';
import { hullOf } from '../../../../physics-core/shapes/hull.js';
import { close, random, type Vec3 } from '../../helpers.js';

function cut(solid: Cuttable, normal: Vec3, offset: number) {
  const length = Math.hypot(...normal);
  const out = new Float64Array(CUT);
  solid.below(Float64Array.of(...normal.map((each) => each / length), offset), out);
  const volume = out[BELOW.volume]!;
  const moment = [...out.subarray(BELOW.moment, BELOW.moment + 3)] as Vec3;
  return { volume, moment, area: out[BELOW.area]! };
}

const box = (half: Vec3): Cuttable => cutOf({ kind: 'box', half })!;

/** Both cuts, each relative to the whole of its kind. */
function alike(
  one: ReturnType<typeof cut>,
  other: ReturnType<typeof cut>,
  size: number,
  error: number,
): void {
  close(one.volume / size ** 3, other.volume / size ** 3, error);
  close(one.area / size ** 2, other.area / size ** 2, error);
  for (let k = 0; k < 3; k++)
    close(one.moment[k]! / size ** 4, other.moment[k]! / size ** 4, error);
}

test('a box that lies level is cut at its depth', () => {
  const solid = box([1, 2, 3]);
  alike(
    cut(solid, [0, 1, 0], 0.5),
    { volume: 6 * 2 * 2.5, moment: [0, 30 * -0.75, 0], area: 12 },
    1,
    1e-12,
  );
  alike(cut(solid, [0, 1, 0], -2.5), { volume: 0, moment: [0, 0, 0], area: 0 }, 1, 1e-12);
  alike(cut(solid, [0, 1, 0], 2.5), { volume: 48, moment: [0, 0, 0], area: 0 }, 1, 1e-12);
});

test('a corner of a box is a tetrahedron', () => {
  // The plane x + y + z = -2 takes edges of 1 off the corner at -1 -1 -1.
  const found = cut(box([1, 1, 1]), [1, 1, 1], -2 / Math.sqrt(3));
  const middle = (-0.75 * 1) / 6;
  alike(
    found,
    { volume: 1 / 6, moment: [middle, middle, middle], area: Math.sqrt(3) / 2 },
    1,
    1e-12,
  );
});

test('a ball is cut by the cap’s formulas', () => {
  const found = cut(ballCut(2), [0, 0, 1], -1);
  alike(
    found,
    { volume: (Math.PI * 5) / 3, moment: [0, 0, -(Math.PI / 4) * 9], area: Math.PI * 3 },
    1,
    1e-12,
  );
});

test('half of a cylinder on its side, and of a cone', () => {
  alike(
    cut(new FrustumCut(2, 2, 3), [1, 0, 0], 0),
    { volume: Math.PI * 12, moment: [-(2 / 3) * 8 * 6, 0, 0], area: 24 },
    1,
    1e-11,
  );
  alike(
    cut(new FrustumCut(2, 0, 1.5), [0, 0, 1], 0),
    { volume: 2 * Math.PI, moment: [0, -0.75 * 2 * Math.PI, -4], area: 6 },
    1,
    1e-11,
  );
});

test('a cylinder that leans floats by half of it, whatever the angle', () => {
  for (const lean of [1e-12, 1e-7, 1e-3, 0.3, 0.9, 1.4, 1.57, Math.PI / 2]) {
    const found = cut(new FrustumCut(1, 1, 2), [Math.sin(lean), Math.cos(lean), 0], 0);
    close(found.volume, 2 * Math.PI, 1e-11);
    if (lean < 1) close(found.area, Math.PI / Math.cos(lean), 1e-9);
  }
});

/** So fine a skin that it is the solid's, within that share. */
const ROUND = 3000;
const FINE = 1e-5;

/** The same frustum of triangles. */
function facets(bottom: number, top: number, half: number): Cuttable {
  const points: number[] = [0, -half, 0, 0, half, 0];
  const index: number[] = [];
  for (let i = 0; i < ROUND; i++) {
    const angle = (2 * Math.PI * i) / ROUND;
    for (const [radius, y] of [
      [bottom, -half],
      [top, half],
    ] as const)
      points.push(radius * Math.sin(angle), y, radius * Math.cos(angle));
    const a = 2 + 2 * i;
    const b = 2 + 2 * ((i + 1) % ROUND);
    index.push(0, b, a, 1, a + 1, b + 1, a, b, b + 1, a, b + 1, a + 1);
  }
  return new FacetCut(points, index);
}

test('cylinders, cones and frusta are cut as those of many triangles are, by any plane', () => {
  const next = random(7);
  for (const [bottom, top, half] of [
    [1, 1, 1],
    [1, 0, 1],
    [0, 1, 0.4],
    [1, 0.3, 2],
    [0.2, 0.21, 3],
  ] as const) {
    const exact = new FrustumCut(bottom, top, half);
    const fine = facets(bottom, top, half);
    for (let i = 0; i < 60; i++) {
      const normal = [next() - 0.5, next() - 0.5, next() - 0.5] as Vec3;
      // Along the side of a cone, and along an axis, too.
      if (i % 6 === 0) normal[1] = 0;
      if (i % 6 === 1) normal[1] = ((bottom - top) / (2 * half)) * Math.hypot(normal[0], normal[2]);
      const offset = (2 * next() - 1) * 1.2;
      alike(cut(exact, normal, offset), cut(fine, normal, offset), 2 * half + bottom + top, FINE);
    }
  }
});

test('an ellipsoid is the box’s cousin: a ball that is made longer', () => {
  const solid = new EllipsoidCut([4, 1, 1, 0, 0, 0]);
  alike(
    cut(solid, [1, 0, 0], 0),
    { volume: (4 / 3) * Math.PI, moment: [-(Math.PI / 4) * 4, 0, 0], area: Math.PI },
    1,
    1e-12,
  );
});

test('what is below and what is above are the whole, for each solid', () => {
  const next = random(3);
  const solids: [Cuttable, number][] = [
    [box([0.5, 1, 2]), 8],
    [ballCut(0.8), (4 / 3) * Math.PI * 0.512],
    [new FrustumCut(0.5, 0.2, 0.7), ((Math.PI * 1.4) / 3) * (0.25 + 0.1 + 0.04)],
    [new EllipsoidCut([1, 2, 3, 0.3, 0.2, 0.1]), NaN],
  ];
  for (const [solid, whole] of solids)
    for (let i = 0; i < 100; i++) {
      const normal = [next() - 0.5, next() - 0.5, next() - 0.5] as Vec3;
      const offset = 2 * next() - 1;
      const below = cut(solid, normal, offset);
      const above = cut(solid, normal.map((each) => -each) as Vec3, -offset);
      const all = Number.isNaN(whole) ? cut(solid, [0, 1, 0], 99).volume : whole;
      close(below.volume + above.volume, all, 1e-11);
      close(below.area, above.area, 1e-9);
    }
});

test('a rough hull of 200 points is cut as a million samples say', () => {
  const next = random(11);
  const points = Array.from({ length: 200 }, () => [next() - 0.5, next() - 0.5, next() - 0.5]);
  const hull = hullOf(points.flat())!;
  const solid = cutOf({ kind: 'hull', points: points.flat(), hull })!;
  const normal: Vec3 = [0.3, 0.9, -0.2];
  const size = Math.hypot(...normal);
  const offset = 0.07;
  const faces = hull.triangles.map((corners) => planeOf(corners.map((i) => points[i]!)));
  let volume = 0;
  const moment = [0, 0, 0];
  const samples = 1_000_000;
  for (let i = 0; i < samples; i++) {
    const at = [next() - 0.5, next() - 0.5, next() - 0.5];
    if (dot(at, normal) / size > offset || faces.some(([n, d]) => dot(at, n) > d)) continue;
    volume += 1 / samples;
    for (let k = 0; k < 3; k++) moment[k]! += at[k]! / samples;
  }
  const found = cut(solid, normal, offset);
  // Half of them are inside: the standard error of a mean of a million.
  close(found.volume, volume, 4 * 0.5e-3);
  for (let k = 0; k < 3; k++) close(found.moment[k]!, moment[k]!, 4 * 0.3e-3);
});

const dot = (a: readonly number[], b: readonly number[]): number =>
  a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;

function planeOf([a, b, c]: number[][]): [normal: number[], offset: number] {
  const [u, v] = [b!, c!].map((end) => end.map((each, k) => each - a![k]!));
  const normal = [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return u![i]! * v![j]! - u![j]! * v![i]!;
  });
  return [normal, dot(normal, a!)];
}
