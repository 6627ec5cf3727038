import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../physics-core/create.js';
import {
  addBody,
  box,
  close,
  sphere,
  position,
  WEIGHTLESS,
  world,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { flat } from '../../effects/deformables/helpers.js';
import type { Row } from './row.js';
import { softDragRow } from './soft-dragging.js';

/** m/s². */
const G = 9.8;

/** A metre square, upright, of four by four cells; it touches nothing. */
const UPRIGHT = { size: [1, 1], subdivision: [4, 4], thickness: 0 };
/** It hangs from its upper edge. */
const TOP = [20, 21, 22, 23, 24];
const HANGING = { fixedIndex: TOP, damping: 5 };

const points = (cloth: Node): Vec3[] => cloth.get('positions') as Vec3[];
const point = (cloth: Node, i: number): Vec3 => points(cloth).at(i)!;

const mean = (cloth: Node, numbers: readonly number[], axis: number): number =>
  numbers.reduce((sum, i) => sum + point(cloth, i)[axis]!, 0) / numbers.length;

const BOTTOM = [0, 1, 2, 3, 4];

/** How far its lower edge is below where it was laid. */
const sag = (cloth: Node): number => -0.5 - mean(cloth, BOTTOM, 1);

const same = (actual: readonly number[], expected: readonly number[], off = 1e-9): void =>
  actual.forEach((value, k) => close(value, expected[k]!, off, 'm'));

/** A cloth that has been there for a quarter of a second, an edit of one of its fields, and some seconds more. */
const edited = (
  field: string,
  fact: string,
  { settings = {}, ...fields }: Record<string, unknown>,
  value: unknown,
  seconds: number,
  judge: (cloth: Node, before: Vec3[]) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world(settings as CreateOptions);
    addBody(w, { fixed: true, position: [0, -10.5, 0], geometry: [box(60, 1, 60)] });
    const cloth = w.add('Cloth', { ...UPRIGHT, ...fields });
    w.advance(0.25);
    const before = points(cloth);
    cloth.set(field, value);
    w.advance(seconds);
    judge(cloth, before);
  },
});

/** On the ground, 10 m below. */
const LYING = { size: [0, 0], geometry: flat(4, 1, -9.95), thickness: 0.1 };

/** A strip that is a metre long and a quarter of a metre wide, level; its first two rows of points are held. */
const CLAMPED = {
  size: [0, 0],
  geometry: flat([8, 2], [1, 0.25], 0),
  fixedIndex: [0, 1, 9, 10, 18, 19],
  bendStiffness: 40,
  damping: 5,
};

export const clothRows: Row[] = [
  edited('enabled', 'FALSE: it stands still', {}, false, 0.5, (cloth, before) =>
    points(cloth).forEach((each, i) => same(each, before[i]!)),
  ),
  edited(
    'geometry',
    'lays it anew',
    { size: [0, 0], geometry: flat(2, 1, 0) },
    flat(1, 2, 3),
    0,
    (cloth) => {
      assert.equal(points(cloth).length, 4);
      same(point(cloth, 3), [1, 3, 1]);
    },
  ),
  edited('size', 'lays it anew', {}, [2, 3], 0, (cloth) => {
    assert.equal(points(cloth).length, 25);
    same(point(cloth, 24), [1, 1.5, 0]);
  }),
  edited('subdivision', 'divides it into so many cells', {}, [2, 1], 0, (cloth) => {
    assert.equal(points(cloth).length, 6);
    same(point(cloth, 4), [0, 0.5, 0]);
  }),
  edited(
    'mass',
    'a heavier one is stretched more by its own weight',
    { ...HANGING, stretchStiffness: 500 },
    3,
    8,
    (cloth) => close(sag(cloth), (3 * G) / 2 / 500, 1e-3, 'm'),
  ),
  edited('thickness', '0: it lies on nothing, and falls', LYING, 0, 0.5, (cloth, before) =>
    close(point(cloth, 12)[1], before[12]![1] - (G * 0.5 ** 2) / 2, 0.05, 'm'),
  ),
  edited(
    'stretchStiffness',
    'it gives way to its own weight',
    HANGING,
    500,
    8,
    (cloth, [, , [, middle]]) => {
      close(middle, -0.5, 5e-3, 'm');
      close(sag(cloth), G / 2 / 500, 1e-3, 'm');
    },
  ),
  edited(
    'shearStiffness',
    'its squares are as slanted as it lets them be',
    { ...HANGING, settings: { gravity: [1, 0, 0] } },
    50,
    8,
    (cloth) => close(mean(cloth, BOTTOM, 0), 1 / 2 / 50, 1e-3, 'm'),
  ),
  edited(
    'bendStiffness',
    'it bends as a plate does whose edge is clamped',
    CLAMPED,
    80,
    8,
    (cloth) => {
      // Clamped amid the row of cells that is held.
      const beam = (G * 0.9375 ** 4) / 8 / 80 / 0.25;
      close(-mean(cloth, [8, 17, 26], 1), beam, beam / 5, 'm');
    },
  ),
  {
    field: 'damping',
    fact: 'this share of its speed is lost in a second',
    run: async () => {
      const w = await world();
      const cloth = w.add('Cloth', UPRIGHT);
      const speed = (): number => {
        const [, before] = point(cloth, 12);
        const seconds = w.step();
        return (before - point(cloth, 12)[1]) / seconds;
      };
      w.advance(0.25);
      w.settings.set('gravity', [0, 0, 0]);
      w.step();
      cloth.set('damping', 2);
      w.step();
      const first = speed();
      const seconds = w.advance(1) + w.timeStep;
      close(speed() / first, Math.exp(-2 * seconds), 1e-6);
    },
  },
  edited(
    'friction',
    '0: it slides on what it lies on',
    { ...LYING, settings: { gravity: [2, -G, 0] } },
    0,
    1,
    (cloth, before) => {
      same([before[12]![0]], [0], 1e-3);
      close(point(cloth, 12)[0], 1, 0.05, 'm');
    },
  ),
  edited('fixedIndex', 'holds these points where they are', {}, TOP, 0.5, (cloth, before) => {
    for (const i of TOP) same(point(cloth, i), before[i]!);
    close(sag(cloth), 0.5 - before[24]![1], 0.01, 'm');
  }),
  edited(
    'tearStrain',
    'what hangs in threads that are stretched by more than that falls',
    { ...HANGING, damping: 0, stretchStiffness: 100 },
    0.02,
    0.5,
    (cloth) => {
      same([mean(cloth, TOP, 1)], [0.5]);
      assert.ok(sag(cloth) > 0.5, 'it hangs on');
    },
  ),
  edited('wind', 'takes it along', { settings: WEIGHTLESS }, [0, 0, 2], 1, (cloth) => {
    // Half of the air's density on a square metre, by the square of how much faster that is: a kilogram.
    const slower = 1 + (1.225 / 2) * 2;
    const way = 2 - Math.log(slower) / (1.225 / 2);
    close(point(cloth, 12)[2], way, 0.02, 'm');
  }),
  {
    field: 'selfCollision',
    fact: 'TRUE: what falls on another part of it lies on that',
    run: async () => {
      const w = await world();
      const [lower, upper] = [flat(4, 1, 0), flat(4, 0.8, 0.3)];
      const index = [...lower.index, ...upper.index.map((i) => i + 25)];
      const cloth = w.add('Cloth', {
        geometry: { ...lower, coord: [...lower.coord, ...upper.coord], index },
        fixedIndex: [...Array(25).keys()],
        thickness: 0.04,
        damping: 1,
      });
      w.step();
      cloth.set('selfCollision', true);
      w.advance(2);
      for (const [, y] of points(cloth).slice(25)) close(y, 0.04, 0.02, 'm');
    },
  },
  softDragRow('Cloth', UPRIGHT),
  {
    field: 'positions',
    fact: 'where its points are, told with each step that moves them',
    run: async () => {
      const w = await world();
      const cloth = w.add('Cloth', UPRIGHT);
      const told: Vec3[][] = [];
      cloth.on('coord_changed', (value) => told.push(value as Vec3[]));
      w.step(2);
      assert.equal(told.length, 2);
      assert.deepEqual(told[1], points(cloth));
      const fallen = (-G * w.time ** 2) / 2;
      same(point(cloth, 24), [0.5, 0.5 + fallen, 0], 1e-3);
    },
  },
];

/** What the effect does beside the fields. */
export const givingRows: Row[] = [
  {
    effect: 'deformables',
    fact: 'a cloth falls where nothing else moves',
    run: async () => {
      const w = await world();
      const cloth = w.add('Cloth', UPRIGHT);
      w.step(10);
      close(point(cloth, 12)[1], (-G * w.time ** 2) / 2, 1e-3, 'm');
    },
  },
  {
    effect: 'deformables',
    fact: 'a ball on a cloth that is held by its edge goes no lower than that gives way',
    run: async () => {
      const w = await world();
      const edge = [0, 1, 2, 3, 4, 5, 9, 10, 14, 15, 19, 20, 21, 22, 23, 24];
      const geometry = flat(4, 1, 0);
      w.add('Cloth', { geometry, fixedIndex: edge, thickness: 0.02, stretchStiffness: 300 });
      const ball = addBody(w, { mass: 0.1, position: [0, 0.32, 0], geometry: [sphere(0.3)] });
      w.advance(2);
      assert.ok(position(ball)[1] > 0, `${position(ball).join()}`);
    },
  },
];
