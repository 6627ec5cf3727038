import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../physics-core/create.js';
import { addBody, box, close, sphere, world, type Node, type Vec3 } from '../../helpers.js';
import type { Row } from './row.js';
import { softDragRow } from './soft-dragging.js';

/** m/s². */
const G = 9.8;

const points = (body: Node): Vec3[] => body.get('positions') as Vec3[];

const same = (actual: readonly Vec3[], expected: readonly Vec3[]): void =>
  actual.forEach((at, i) => close(at, expected[i]!, 1e-9, 'm'));

/** The mean of its points along an axis. */
const middle = (body: Node, axis: number): number =>
  points(body).reduce((sum, at) => sum + at[axis]!, 0) / points(body).length;

const least = (body: Node, axis: number): number =>
  Math.min(...points(body).map((at) => at[axis]!));

const width = (body: Node): number => -2 * least(body, 0);

/** Numbers of the points of a Box that are at its top. */
const TOP = [4, 5, 6, 7];

/** A block of 10 kg and a metre; the points of its top come last. */
const BLOCK = {
  geometry: {
    type: 'IndexedTriangleSet',
    coord: [
      ...[-0.5, -0.5, -0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0.5, -0.5, -0.5, 0.5],
      ...[-0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5, 0.5, 0.5, -0.5, 0.5, 0.5],
    ],
    index: [
      ...[0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5],
      ...[1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4],
    ],
  },
  mass: 10,
  youngsModulus: 1e4,
};

/** As a rod that is pressed by its own weight: half of m g L / E A. */
const sag = (mass: number, youngsModulus: number): number => (mass * G) / 2 / youngsModulus;

/** How far its top has come down. */
const pressed = (body: Node): number =>
  0.5 - TOP.reduce((sum, i) => sum + points(body)[i]![1], 0) / TOP.length;

/** A soft body that has been there for a quarter of a second, an edit of one of its fields, and some seconds more. */
const edited = (
  field: string,
  fact: string,
  { settings = {}, floor = -10, ...fields }: Record<string, unknown>,
  value: unknown,
  seconds: number,
  judge: (body: Node, before: Vec3[]) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world(settings as CreateOptions);
    const position = [0, (floor as number) - 0.5, 0];
    addBody(w, { fixed: true, position, geometry: [box(60, 1, 60)] });
    const body = w.add('SoftBody', { ...BLOCK, ...fields });
    w.advance(0.25);
    const before = points(body);
    body.set(field, value);
    w.advance(seconds);
    judge(body, before);
  },
});

const LYING = { floor: -0.5, damping: 2 };
/** It is pressed by its own weight alone. */
const STANDING = { ...LYING, friction: 0, poissonsRatio: 0, youngsModulus: 5e3 };

/** A ball of rubber with air in it. */
const BALL = {
  geometry: sphere(0.5),
  mass: 1,
  youngsModulus: 1e5,
  damping: 5,
  settings: { gravity: [0, 0, 0] },
};

export const softBodyRows: Row[] = [
  edited('enabled', 'FALSE: it stands still', {}, false, 0.5, (body, before) =>
    same(points(body), before),
  ),
  edited('geometry', 'lays it anew', {}, sphere(2), 0, (body) =>
    close(least(body, 1), -2, 0.02, 'm'),
  ),
  edited('mass', 'a heavier one is pressed more by its own weight', STANDING, 30, 4, (body) =>
    close(pressed(body), sag(30, 5e3), 3e-3, 'm'),
  ),
  edited('youngsModulus', 'a softer one is pressed more', STANDING, 2e3, 4, (body) =>
    close(pressed(body), sag(10, 2e3), 3e-3, 'm'),
  ),
  edited(
    'poissonsRatio',
    'what is pressed gets wider by this share of it',
    { ...STANDING, youngsModulus: 2e3 },
    0.4,
    4,
    (body) => close(width(body), 1 + (0.4 * 10 * G) / 2e3, 6e-3, 'm'),
  ),
  edited('pressure', 'blows it up', { ...BALL, pressure: 1 }, 30, 2, (body) =>
    assert.ok(width(body) > 1.05, `${width(body)} m`),
  ),
  edited(
    'thickness',
    'a thin skin is blown up more',
    { ...BALL, mass: 10, pressure: 300, thickness: 0.01 },
    2e-3,
    2,
    (body) => assert.ok(width(body) > 1.15, `${width(body)} m`),
  ),
  edited('damping', 'it falls more slowly', {}, 4, 1, (body, [[, before]]) => {
    const fallen = (way: number): number => -0.5 - way;
    assert.ok(fallen(least(body, 1)) < fallen(before!) + 3, `${least(body, 1)} m`);
  }),
  edited(
    'friction',
    '0: it slides on what it lies on',
    { ...LYING, damping: 0, settings: { gravity: [2, -G, 0] } },
    0,
    1,
    (body) => close(middle(body, 0), 1, 0.1, 'm'),
  ),
  edited('fixedIndex', 'holds these points where they are', {}, TOP, 0.5, (body, before) =>
    same(points(body).slice(4), before.slice(4)),
  ),
  softDragRow('SoftBody', BLOCK),
  {
    field: 'positions',
    fact: 'where its points are, told with each step that moves them',
    run: async () => {
      const w = await world();
      const body = w.add('SoftBody', BLOCK);
      const told: Vec3[][] = [];
      body.on('coord_changed', (value) => told.push(value as Vec3[]));
      w.step(2);
      assert.equal(told.length, 2);
      assert.deepEqual(told[1], points(body));
      close(least(body, 1), -0.5 - (G * w.time ** 2) / 2, 1e-3, 'm');
    },
  },
];
