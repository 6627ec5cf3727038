import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../physics-core/create.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  box,
  close,
  position,
  sphere,
  velocity,
  WEIGHTLESS,
  world,
  type Node,
  type Vec3,
} from '../../helpers.js';
import type { Row } from './row.js';
import { softDragRow } from './soft-dragging.js';

/** m/s². */
const G = 9.8;

/** Two metres, level, of eight links; it touches nothing. */
const LEVEL = { points: [0, 0, 0, 2, 0, 0], segments: 8, radius: 0 };
/** It hangs from its first point. */
const HANGING = { points: [0, 0, 0, 0, -2, 0], segments: 8, radius: 0, fixedIndex: [0] };

const addRope = (w: World, fields = {}): Node => w.add('Rope', { ...LEVEL, ...fields });
const points = (rope: Node): Vec3[] => rope.get('positions') as Vec3[];
const point = (rope: Node, i: number): Vec3 => points(rope).at(i)!;

const same = (actual: readonly number[], expected: readonly number[], off = 1e-9): void =>
  actual.forEach((value, k) => close(value, expected[k]!, off, 'm'));

const addBall = (w: World, fields = {}) =>
  addBody(w, { position: [2, 0, 0], geometry: [sphere(0.1)], ...fields });

/** A rope that has been there for a quarter of a second, an edit of one of its fields, and some seconds more. */
const edited = (
  field: string,
  fact: string,
  { settings = {}, ...fields }: Record<string, unknown>,
  value: unknown,
  seconds: number,
  judge: (rope: Node, before: Vec3[]) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world(settings as CreateOptions);
    addBody(w, { fixed: true, position: [0, -10.5, 0], geometry: [box(60, 1, 60)] });
    const rope = addRope(w, fields);
    w.advance(0.25);
    const before = points(rope);
    rope.set(field, value);
    w.advance(seconds);
    judge(rope, before);
  },
});

/** Along the ground, 10 m below. */
const LYING = { points: [0, -9.95, 0, 2, -9.95, 0], radius: 0.05 };

const rows: Row[] = [
  edited('enabled', 'FALSE: it stands still', {}, false, 0.5, (rope, before) =>
    points(rope).forEach((each, i) => same(each, before[i]!)),
  ),
  edited(
    'geometry',
    'lays it along another line',
    { points: [], segments: 0, geometry: { type: 'LineSet', coord: [0, 0, 0, 1, 0, 0] } },
    { type: 'IndexedLineSet', coord: [0, 5, 0, 1, 5, 0, 2, 5, 0], coordIndex: [2, 0, -1, 1] },
    0,
    (rope) => {
      assert.equal(points(rope).length, 2);
      same(point(rope, 0), [2, 5, 0]);
      same(point(rope, 1), [0, 5, 0]);
    },
  ),
  edited('points', 'lays it anew', {}, [0, 3, 0, 4, 3, 0], 0, (rope) => {
    assert.equal(points(rope).length, 9);
    same(point(rope, 4), [2, 3, 0]);
  }),
  edited('segments', 'divides its line into so many links', {}, 4, 0, (rope) => {
    assert.equal(points(rope).length, 5);
    same(point(rope, 1), [0.5, 0, 0]);
  }),
  {
    field: 'mass',
    fact: 'what pulls it along straight is slowed by all of it',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const rope = addRope(w);
      const ball = addBall(w);
      w.add('SoftBodyAttachment', { softBody: rope, index: 8, body: ball });
      w.advance(0.25);
      rope.set('mass', 2);
      ball.set('linearVelocity', [3, 0, 0]);
      w.advance(0.25);
      close(velocity(ball)[0], 1, 1e-3, 'm/s');
    },
  },
  edited('radius', '0: it lies on nothing, and falls', LYING, 0, 0.5, (rope, before) =>
    close(point(rope, 4)[1], before[4]![1] - (G * 0.5 ** 2) / 2, 0.05, 'm'),
  ),
  {
    field: 'stretchStiffness',
    fact: 'it gives way to what hangs from it',
    run: async () => {
      const w = await world();
      const rope = addRope(w, { ...HANGING, mass: 0.001 });
      const ball = addBall(w, { position: [0, -2, 0], autoDamp: true, linearDampingFactor: 0.9 });
      w.add('SoftBodyAttachment', { softBody: rope, index: 8, body: ball });
      w.advance(0.25);
      close(position(ball)[1], -2, 1e-3, 'm');
      rope.set('stretchStiffness', 980);
      w.advance(10);
      // A hundredth of its length.
      close(position(ball)[1], -2.02, 1e-3, 'm');
    },
  },
  {
    field: 'damping',
    fact: 'this share of its speed is lost in a second',
    run: async () => {
      const w = await world();
      const rope = addRope(w);
      const speed = (): number => {
        const [, before] = point(rope, 4);
        const seconds = w.step();
        return (before - point(rope, 4)[1]) / seconds;
      };
      w.advance(0.25);
      w.settings.set('gravity', [0, 0, 0]);
      w.step();
      rope.set('damping', 2);
      const first = speed();
      const seconds = w.advance(1) + w.timeStep;
      close(speed() / first, Math.exp(-2 * seconds), 1e-6);
    },
  },
  {
    field: 'bendStiffness',
    fact: 'it bends as a beam does where it is held by two points',
    run: async () => {
      const w = await world();
      const rope = addRope(w, { segments: 4, fixedIndex: [0, 1], damping: 5 });
      w.advance(0.25);
      rope.set('bendStiffness', 50);
      w.advance(5);
      // As a beam that is clamped amid the link that is held, but for its few links: ρ g L⁴ / 8 E I.
      const sag = (0.5 * G * 1.75 ** 4) / 8 / 50;
      close(point(rope, 4)[1], -sag, sag / 10, 'm');
    },
  },
  edited(
    'friction',
    '0: it slides on what it lies on',
    { ...LYING, settings: { gravity: [2, -G, 0] } },
    0,
    1,
    (rope, before) => {
      same([before[4]![0]], [1], 1e-3);
      close(point(rope, 4)[0], 2, 0.05, 'm');
    },
  ),
  {
    field: 'selfCollision',
    fact: 'what hangs over another part of it does not go through',
    run: async () => {
      const w = await world();
      // A bar along x, held at both ends of each link; from its end on it comes back above it, along z.
      const rope = addRope(w, {
        points: [
          [-1, 0, 0],
          [1, 0, 0],
          [1, 0.5, 1],
          [0, 0.1, 1],
          [0, 0.1, -0.5],
        ],
        segments: 0,
        radius: 0.04,
        fixedIndex: [0, 1, 3],
      });
      w.step(2);
      rope.set('selfCollision', true);
      w.advance(1);
      const [, y, z] = point(rope, 4);
      close(Math.hypot(y - 0.1, z - 1), 1.5, 1e-3, 'm');
      // Straight over the bar, or hanging down beside it: below the bar it would be at half of its length.
      assert.ok(y > -0.6, `${y} m`);
    },
  },
  edited('fixedIndex', 'holds these points where they are', {}, [4], 0.5, (rope, before) => {
    same(point(rope, 4), before[4]!);
    assert.ok(Math.hypot(...point(rope, 0).map((x, k) => x - before[0]![k]!)) > 0.1);
  }),
  softDragRow('Rope', LEVEL),
  {
    field: 'positions',
    fact: 'where its points are, told with each step that moves them',
    run: async () => {
      const w = await world();
      const rope = addRope(w);
      const told: Vec3[][] = [];
      rope.on('coord_changed', (value) => told.push(value as Vec3[]));
      w.step(2);
      assert.equal(told.length, 2);
      assert.deepEqual(told[1], points(rope));
      const fallen = (-G * w.time ** 2) / 2;
      for (const [x, y, z] of points(rope)) same([y, z, x % 0.25], [fallen, 0, 0], 1e-3);
    },
  },
];

export const ropeRows: Row[] = rows;

// ---- what ties it ---------------------------------------------------------------------------------------------------

/** A rope whose last point is tied to a ball, after a quarter of a second, an edit of one field of the attachment, and another half. */
const tied = (
  field: string,
  fact: string,
  value: (all: { rope: Node; other: Node; ball: Node; stone: Node }) => unknown,
  judge: (all: { rope: Node; other: Node; ball: Node; stone: Node }) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world();
    const rope = addRope(w, { fixedIndex: [0] });
    const other = addRope(w, { points: [0, 0, 5, 2, 0, 5], fixedIndex: [0] });
    const ball = addBall(w);
    const stone = addBall(w, { position: [2, 0, -1] });
    const tie = w.add('SoftBodyAttachment', { softBody: rope, index: 8, body: ball });
    w.advance(0.25);
    same(point(rope, 8), position(ball), 1e-4);
    tie.set(field, value({ rope, other, ball, stone }));
    w.advance(0.5);
    judge({ rope, other, ball, stone });
  },
});

export const attachmentRows: Row[] = [
  tied(
    'softBody',
    'takes a point of another rope',
    ({ other }) => other,
    ({ other, ball }) => same(point(other, 8), position(ball as never), 1e-3),
  ),
  tied(
    'index',
    'takes another point',
    () => 5,
    ({ rope, ball }) => same(point(rope, 5), position(ball as never), 1e-3),
  ),
  tied(
    'body',
    'ties to another body',
    ({ stone }) => stone,
    ({ rope, stone }) => same(point(rope, 8), position(stone as never), 1e-3),
  ),
  tied(
    'position',
    'ties to another place on the body',
    () => [0, 0, 0.3],
    ({ rope, ball }) => {
      const [x, y, z] = position(ball as never).map((each, k) => each - point(rope, 8)[k]!);
      close(Math.hypot(x!, y!, z!), 0.3, 1e-3, 'm');
    },
  ),
];

/** What the effect does beside the fields. */
export const hangingRows: Row[] = [
  {
    effect: 'ropes',
    fact: 'it falls where nothing else moves',
    run: async () => {
      const w = await world();
      const rope = addRope(w);
      w.step(10);
      close(point(rope, 4)[1], (-G * w.time ** 2) / 2, 1e-3, 'm');
    },
  },
  ...[undefined, 10].map((iterations): Row => ({
    effect: 'ropes',
    fact: `what hangs on it and is struck from above goes no lower, ${iterations ? "by Bullet's iterations" : 'solved directly'}`,
    run: async () => {
      const w = await world(iterations ? { iterations } : {});
      const rope = addRope(w, HANGING);
      const ball = addBall(w, { position: [0, -2, 0] });
      w.add('SoftBodyAttachment', { softBody: rope, index: 8, body: ball });
      addBall(w, { position: [0, -1.4, 0] });
      let least = 0;
      for (let i = 0; i < 60; i++) {
        w.step();
        least = Math.min(least, position(ball)[1]);
      }
      // At 2.8 m/s it would go 23 mm in the step in which it is struck.
      close(least, -2, 8e-3, 'm');
    },
  })),
  {
    effect: 'ropes',
    fact: 'what is thrown on a rope goes round where that is tied, as fast as ever',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const rope = addRope(w, { mass: 0.0001 });
      const ball = addBall(w, { linearVelocity: [0, 2, 0] });
      w.add('SoftBodyAttachment', { softBody: rope, index: 0 });
      w.add('SoftBodyAttachment', { softBody: rope, index: 8, body: ball });
      w.advance(3);
      close(Math.hypot(...position(ball)), 2, 1e-2, 'm');
      close(Math.hypot(...velocity(ball)), 2, 1e-2, 'm/s');
    },
  },
];
