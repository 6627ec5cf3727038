import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BallSolid } from '../../../../../physics-core/effects/particles/collide/ball.js';
import { BoxSolid } from '../../../../../physics-core/effects/particles/collide/box.js';
import { EggSolid } from '../../../../../physics-core/effects/particles/collide/egg.js';
import { FrustumSolid } from '../../../../../physics-core/effects/particles/collide/frustum.js';
import { HullSolid } from '../../../../../physics-core/effects/particles/collide/hull.js';
import { SheetSolid, SKIN } from '../../../../../physics-core/effects/particles/collide/sheet.js';
import { FOUND, type Solid } from '../../../../../physics-core/effects/particles/collide/solid.js';
import { hullFaces } from '../../../../../physics-core/shapes/forms/hull-faces.js';
import { hullOf } from '../../../../../physics-core/shapes/hull.js';
import { close, random, type Vec3 } from '../../../helpers.js';
import {
  firstTouch,
  fromBall,
  fromBox,
  fromEgg,
  fromFrustum,
  fromHull,
  gradient,
  inner,
  plus,
  size,
  trianglesOf,
  type Distance,
} from './distances.js';

const found = new Float64Array(FOUND);

function meets(solid: Solid, from: Vec3, to: Vec3, radius = 0, most = 1) {
  const way = Float64Array.from([...from, ...plus(to, from, -1), radius, most]);
  if (!solid.meets(way, found)) return undefined;
  const [share, depth, ...normal] = found;
  return { share: share!, depth: depth!, normal: normal as Vec3 };
}

const next = random(7);
const either = (most: number): number => (2 * next() - 1) * most;
const somewhere = (most: number): Vec3 => [either(most), either(most), either(most)];

/** Corners of a stone. */
const stone = Array.from({ length: 14 }, () => {
  const at = somewhere(1);
  return at.map((value, i) => (value / size(at)) * [0.9, 0.6, 0.4][i]!);
}).flat();
const hull = hullOf(stone)!;

/** A hilly field. */
const FIELD = 7;
const field = Array.from({ length: FIELD * FIELD }, (_, i) => [
  (i % FIELD) * 0.3 - 0.9,
  0.4 * Math.sin(i),
  Math.floor(i / FIELD) * 0.3 - 0.9,
]).flat();
const squares = Array.from({ length: (FIELD - 1) ** 2 }, (_, i) => {
  const at = (i % (FIELD - 1)) + FIELD * Math.floor(i / (FIELD - 1));
  return [
    [at, at + FIELD, at + 1],
    [at + 1, at + FIELD, at + FIELD + 1],
  ] as [number, number, number][];
}).flat();

/** What is made of several convex things is met where the first of them is. */
interface Case {
  name: string;
  solid: Solid;
  parts: Distance[];
}

const cases: Case[] = [
  { name: 'a ball', solid: new BallSolid(0.7), parts: [fromBall(0.7)] },
  { name: 'a box', solid: new BoxSolid([0.7, 0.3, 0.5]), parts: [fromBox([0.7, 0.3, 0.5])] },
  { name: 'a plate', solid: new BoxSolid([0.8, 5e-4, 0.8]), parts: [fromBox([0.8, 5e-4, 0.8])] },
  {
    name: 'a cylinder',
    solid: new FrustumSolid(0.6, 0.6, 0.5),
    parts: [fromFrustum(0.6, 0.6, 0.5)],
  },
  { name: 'a cone', solid: new FrustumSolid(0.7, 0, 0.6), parts: [fromFrustum(0.7, 0, 0.6)] },
  {
    name: 'a cone that is cut off',
    solid: new FrustumSolid(0.3, 0.6, 0.5),
    parts: [fromFrustum(0.3, 0.6, 0.5)],
  },
  {
    name: 'an ellipsoid',
    solid: new EggSolid([0.8, 0.3, 0.5]),
    parts: [fromEgg([0.8, 0.3, 0.5])],
  },
  {
    name: 'a hull',
    solid: new HullSolid(hullFaces(stone, hull.triangles)),
    parts: [fromHull(stone, hull.triangles)],
  },
];

const sheet: Case = {
  name: 'a height field',
  solid: new SheetSolid(field, squares.flat()),
  parts: trianglesOf(field, squares),
};

/** Below it a way only grazes what it passes: which of both it is, rounding may say. */
const GRAZES = 1e-7;

function judge({ name, solid, parts }: Case, from: Vec3, to: Vec3, radius: number): boolean {
  const r = parts.length > 1 ? Math.max(radius, SKIN) : radius;
  const touches = parts.map((distance) => firstTouch(distance, from, to, r));
  if (touches.some(({ least }) => Math.abs(least) < GRAZES)) return false;
  const first = touches.filter(({ share }) => share >= 0).sort((a, b) => a.share - b.share)[0];
  const met = meets(solid, from, to, radius);
  const what = `${name}, radius ${radius}, from ${from.join(' ')} to ${to.join(' ')}`;
  assert.equal(met !== undefined, first !== undefined, what);
  if (!met) return false;
  const distance = (at: Vec3): number => Math.min(...parts.map((each) => each(at)));
  close(met.share, first!.share, 1e-7, `share: ${what}`);
  close(size(met.normal), 1, 1e-12, `unit: ${what}`);
  const gap = distance(from) - r;
  close(met.depth, Math.max(0, -gap), 1e-7, `depth: ${what}`);
  const place = plus(plus(from, plus(to, from, -1), met.share), met.normal, met.depth);
  // A tick along the normal, from where it touches, is a tick more.
  const at = plus(place, met.normal, 1e-4);
  if (gap > 0) close(distance(at) - r, 1e-4, 1e-7, `normal: ${what}`);
  if (gap > 0 && radius > 0.01)
    close(met.normal, gradient(distance, place), 1e-4, `gradient: ${what}`);
  return true;
}

for (const one of [...cases, sheet])
  test(`a way meets ${one.name} where it comes as near as its radius first, and along that normal`, () => {
    for (const radius of [0, 0.02, 0.25]) {
      let met = 0;
      for (let i = 0; i < (one === sheet ? 50 : 120); i++)
        if (judge(one, somewhere(1.3), somewhere(1.3), radius)) met++;
      assert.ok(met > 8, `${met} ways met ${one.name}`);
    }
  });

test('what begins inside is out of it by its depth along the normal, the shortest way there is', () => {
  for (const { name, solid, parts } of cases) {
    for (const radius of [0, 0.1]) {
      for (let i = 0; i < 200; i++) {
        const from = somewhere(0.6);
        const gap = parts[0]!(from) - radius;
        if (gap > -1e-6) continue;
        const met = meets(solid, from, plus(from, somewhere(2)), radius)!;
        const what = `${name} from ${from.join(' ')}`;
        close([met.share, met.depth], [0, -gap], 1e-6, what);
        const place = plus(from, met.normal, met.depth);
        close(parts[0]!(place), radius, 1e-6, `place: ${what}`);
      }
    }
  }
});

test('what begins in the very middle is brought out, too', () => {
  for (const { name, solid, parts } of cases) {
    const met = meets(solid, [0, 0, 0], [0, 0, 0])!;
    // By what is beside it: the middle itself has several nearest points.
    close(met.depth, -parts[0]!([1e-5, 1e-5, 1e-5]), 1e-4, name);
    close(parts[0]!(plus([0, 0, 0], met.normal, met.depth)), 0, 1e-6, name);
  }
});

test('a way along a face, in touch with it, meets nothing, and neither does one that leaves it', () => {
  for (const radius of [0, 0.1]) {
    const top = 0.3 + radius;
    const box = new BoxSolid([0.7, 0.3, 0.5]);
    const flat = new SheetSolid(
      [-1, 0.3, -1, 1, 0.3, -1, 1, 0.3, 1, -1, 0.3, 1],
      [0, 2, 1, 0, 3, 2],
    );
    for (const solid of [box, new FrustumSolid(0.7, 0.7, 0.3)]) {
      assert.equal(meets(solid, [-0.5, top, 0], [0.5, top, 0], radius), undefined);
      assert.equal(meets(solid, [0, top, 0], [0.1, 2, 0], radius), undefined);
      assert.equal(meets(solid, [0, top - 1e-12, 0], [0.1, 2, 0], radius), undefined);
      assert.equal(meets(solid, [-2, top + 1e-6, 0], [2, top + 1e-6, 0], radius), undefined);
    }
    const ball = 0.3 + Math.max(radius, SKIN);
    assert.equal(meets(flat, [-0.5, ball + 1e-12, 0], [0.5, ball + 1e-12, 0], radius), undefined);
    assert.equal(meets(flat, [0, ball, 0], [0.1, 2, 0], radius), undefined);
  }
});

test('what lies on a face and goes into it meets it at once', () => {
  for (const radius of [0, 0.1]) {
    for (const off of [-1e-12, 0, 1e-12]) {
      const met = meets(
        new BoxSolid([0.7, 0.3, 0.5]),
        [0.2, 0.3 + radius + off, 0],
        [0.5, -1, 0],
        radius,
      )!;
      close([met.share, met.depth, ...met.normal], [0, 0, 0, 1, 0], 1e-9);
    }
  }
});

test('between tiles that lie side by side nothing falls', () => {
  const tile = new BoxSolid([0.5, 0.1, 0.5]);
  for (const radius of [0, 0.05]) {
    for (const x of [-0.5, 0.5]) {
      const falls = meets(tile, [x, 1, 0], [x, -1, 0], radius)!;
      close([falls.share, ...falls.normal], [(0.9 - radius) / 2, 0, 1, 0], 1e-9);
      const lies = meets(tile, [x, 0.1 + radius, 0.5], [x, -1, 0.5], radius)!;
      close([lies.share, ...lies.normal], [0, 0, 1, 0], 1e-9);
    }
  }
});

test('a point that lies on a sheet stays on its side, whatever rounding says', () => {
  const points = [-1, 0.1, -1, 1, 0.3, -1, 1, -0.2, 1, -1, 0.15, 1];
  const flat = new SheetSolid(points, [0, 2, 1, 0, 3, 2]);
  for (let n = 0; n < 20; n++) {
    let at: Vec3 = [either(0.5), 1, either(0.5)];
    for (let i = 0; i < 50; i++) {
      let way: Vec3 = [either(0.05), i === 0 ? -2 : -0.05, either(0.05)];
      for (let slides = 0; slides < 4; slides++) {
        const met = meets(flat, at, plus(at, way));
        at = plus(at, way, met?.share ?? 1);
        if (!met) break;
        // It slides along, over the bend between both.
        at = plus(at, met.normal, met.depth);
        assert.ok(met.normal[1] > 0.8, `normal ${met.normal.join(' ')} in step ${i}`);
        const rest = way.map((value) => value * (1 - met.share)) as Vec3;
        way = plus(rest, met.normal, -inner(rest, met.normal));
      }
      if (Math.max(Math.abs(at[0]), Math.abs(at[2])) > 0.9) break;
    }
  }
});

test('a plate of 1 mm is met by what goes a kilometre in a step', () => {
  const plate = new BoxSolid([0.8, 5e-4, 0.8]);
  const sheets = new SheetSolid([-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1], [0, 2, 1, 0, 3, 2]);
  for (const radius of [0, 0.001]) {
    close(
      meets(plate, [0, 500, 0], [0.5, -500, 0.3], radius)!.share,
      0.5 - (5e-4 + radius) / 1000,
      1e-12,
    );
    close(
      meets(sheets, [0, 500, 0], [0.5, -500, 0.3], radius)!.share,
      0.5 - Math.max(radius, SKIN) / 1000,
      1e-12,
    );
  }
});

test('nothing is met later than is asked for', () => {
  for (const { solid } of [...cases, sheet]) {
    const met = meets(solid, [0.1, 2, 0.05], [0.1, -2, 0.05], 0.01)!;
    const sooner = meets(solid, [0.1, 2, 0.05], [0.1, -2, 0.05], 0.01, met.share - 1e-9);
    assert.equal(sooner, undefined);
  }
});
