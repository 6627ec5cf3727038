import assert from 'node:assert/strict';
import type { ShownSurface, WaterVolumeNode } from '../../../../physics-core/water.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  box,
  close,
  position,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
  type Node,
} from '../../helpers.js';
import type { Row } from './row.js';

/** m/s². */
const G = 9.8;

/** Half as heavy as water, a metre wide. */
const LIGHT = { mass: 500, geometry: [box(1)] };
/** As heavy as water: it hangs in it wherever it is. */
const NEUTRAL = { mass: 1000, geometry: [box(1)], linearVelocity: [1, 0, 0] };

/** Without any resistance. */
const IDEAL = { dragCoefficient: 0, liftCoefficient: 0, damping: 0 };
/** What floats lies still after some seconds. */
const THICK = { damping: 6 };

/** Its surface is at y = 0. */
const addPool = (w: World, fields = {}): Node =>
  w.add('WaterVolume', { position: [0, -1, 0], ...fields });

/** So deep and wide that nothing comes to its end. */
const addDeep = (w: World, fields = {}): Node =>
  w.add('WaterVolume', { size: [100, 40, 100], ...IDEAL, ...fields });

interface Before {
  settings?: Record<string, unknown>;
  water(w: World): Node;
  body: Record<string, unknown>;
}

/** Water in which something has been for a quarter of a second, an edit of one of its fields, and some seconds more. */
const edited = (
  field: string,
  fact: string,
  { settings, water, body }: Before,
  value: unknown,
  seconds: number,
  judge: (body: Body, seconds: number, before: number[]) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world(settings);
    const volume = water(w);
    const there = addBody(w, body);
    w.advance(0.25);
    const before = velocity(there);
    volume.set(field, value);
    judge(there, w.advance(seconds), before);
  },
});

/** How far it is from the mean at most. */
function highest(heights: Float32Array): number {
  const mean = heights.reduce((total, each) => total + each, 0) / heights.length;
  return heights.reduce((most, each) => Math.max(most, Math.abs(each - mean)), 0);
}

/** The surface of a pool some seconds after something fell in that then stayed where it was. */
const surface = (
  field: string,
  fact: string,
  fields: Record<string, unknown>,
  value: unknown,
  judge: (shown: ShownSurface) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world();
    const pool = addPool(w, { ...THICK, size: [8, 2, 8], waves: true, ...fields });
    addBody(w, { mass: 2000, geometry: [box(1)], position: [1, 1, 1] });
    w.advance(0.75);
    pool.set(field, value);
    w.advance(12);
    judge((pool as WaterVolumeNode).surface!);
  },
});

const AFLOAT: Before = { water: (w) => addPool(w, THICK), body: LIGHT };
/** Nothing pulls at it. */
const ADRIFT: Before = { settings: WEIGHTLESS, water: addDeep, body: NEUTRAL };

const height = (body: Body): number => position(body)[1];

const rows: Row[] = [
  edited('enabled', 'FALSE: what floated falls', AFLOAT, false, 1, (body, t) =>
    close(height(body), (-G * t ** 2) / 2, 0.01, 'm'),
  ),
  edited('position', 'lifts what floats with it', AFLOAT, [0, -0.5, 0], 8, (body) =>
    close(height(body), 0.5, 1e-3, 'm'),
  ),
  edited(
    'orientation',
    'turns its box: what was at its end is out of it, and falls',
    {
      water: (w) => addPool(w, { ...THICK, size: [40, 2, 4] }),
      body: { ...LIGHT, position: [15, 0, 0] },
    },
    [0, 1, 0, Math.PI / 2],
    1,
    (body, t) => close(height(body), (-G * t ** 2) / 2, 0.01, 'm'),
  ),
  edited(
    'size',
    'half a metre more on top lifts what floats by that',
    AFLOAT,
    [10, 3, 10],
    8,
    (body) => close(height(body), 0.5, 1e-3, 'm'),
  ),
  edited('density', 'of twice as much has it float half as deep', AFLOAT, 2000, 8, (body) =>
    close(height(body), 0.25, 1e-3, 'm'),
  ),
  edited(
    'dragCoefficient',
    'brakes by ½ ρ c A v², of the wetted cross-section',
    ADRIFT,
    1,
    1,
    (body, t) => close(velocity(body)[0], 1 / (1 + t / 2), 1e-3, 'm/s'),
  ),
  edited(
    'liftCoefficient',
    'pushes what goes through the water aslant to the side',
    {
      ...ADRIFT,
      body: {
        mass: 200,
        geometry: [{ type: 'Box', size: [2, 0.1, 1] }],
        orientation: [0, 0, 1, 0.3],
        linearVelocity: [1, 0, 0],
      },
    },
    1,
    0.1,
    (body, _, before) => {
      close(before[1]!, 0, 1e-6, 'm/s');
      assert.ok(velocity(body)[1] > 0.01, String(velocity(body)));
    },
  ),
  edited(
    'damping',
    'is the share of its speed that what hangs in it loses in a second',
    ADRIFT,
    0.5,
    1,
    (body, t) => close(velocity(body)[0], Math.exp(-t / 2), 1e-3, 'm/s'),
  ),
  edited(
    'addedMass',
    'has what rises take half the mass of the water in its place along',
    { water: addDeep, body: LIGHT },
    0.5,
    0.25,
    (body, t, before) => close(velocity(body)[1] - before[1]!, (G / 2) * t, 0.01, 'm/s'),
  ),
  edited('flow', 'takes what floats along', AFLOAT, [0.5, 0, 0], 4, (body) =>
    close(velocity(body), [0.5, 0, 0], 1e-3, 'm/s'),
  ),
  edited(
    'waves',
    'has what falls in lift the water around it',
    {
      water: (w) => addPool(w, { size: [4, 2, 4] }),
      body: { mass: 500, geometry: [box(1)], position: [0, 0.5, 0] },
    },
    true,
    1,
    (body) => {
      const [pool] = [...body.world.nodes].filter(({ type }) => type.name === 'WaterVolume');
      const { heights } = (pool as WaterVolumeNode).surface!;
      assert.ok(
        heights.some((each) => each > 0.01),
        'it makes waves',
      );
    },
  ),
  surface(
    'subdivision',
    'is how many cells the surface has',
    {},
    [16],
    ({ columns, rows, heights }) => {
      assert.deepEqual([columns, rows, heights.length], [16, 16, 256]);
    },
  ),
  surface(
    'edges',
    'OPEN: the waves of what fell in are gone after a while',
    { waveDamping: 0 },
    'OPEN',
    ({ heights }) => assert.ok(highest(heights) < 1e-3, `${highest(heights)} m`),
  ),
  surface('waveDamping', 'stills the waves of what fell in', {}, 4, ({ heights }) =>
    assert.ok(highest(heights) < 1e-3, `${highest(heights)} m`),
  ),
];

export const waterRows: Row[] = rows;

/** What the effect does beside its fields. */
export const floatingRows: Row[] = [
  {
    effect: 'water',
    fact: 'what is half as heavy as water floats half in it',
    run: async () => {
      const w = await world();
      addPool(w, THICK);
      const body = addBody(w, { ...LIGHT, position: [0, 0.2, 0] });
      w.advance(8);
      close(height(body), 0, 1e-3, 'm');
    },
  },
  {
    effect: 'water',
    fact: 'without drag it heaves as far as it did at first',
    run: async () => {
      const w = await world();
      addDeep(w, { position: [0, -20, 0] });
      const body = addBody(w, { mass: 2000, position: [0, 0.1, 0], geometry: [box(2, 1, 2)] });
      w.advance(10);
      // ω² = ρ g A / m.
      close(Math.hypot(height(body), velocity(body)[1] / Math.sqrt(2 * G)), 0.1, 1e-4, 'm');
    },
  },
  {
    effect: 'water',
    fact: 'a body tells when it comes in, and when it leaves',
    run: async () => {
      const w = await world();
      const water = addPool(w);
      const body = addBody(w, LIGHT);
      const told: string[] = [];
      body.on('waterenter', () => told.push('in'));
      body.on('waterleave', () => told.push('out'));
      w.step(2);
      water.set('enabled', false);
      w.step(2);
      assert.deepEqual(told, ['in', 'out']);
    },
  },
  {
    effect: 'waves',
    fact: 'a wave lifts what floats far from where it came from',
    run: async () => {
      const w = await world();
      addPool(w, { ...THICK, size: [20, 2, 20], waves: true });
      const float = addBody(w, { ...LIGHT, position: [6, 0, 0] });
      w.advance(0.5);
      close(height(float), 0, 1e-6, 'm');
      addBody(w, { mass: 4000, geometry: [box(2)], position: [-6, 1.2, 0] });
      let most = 0;
      for (let i = 0; i < 480; i++) {
        w.step();
        most = Math.max(most, height(float));
      }
      assert.ok(most > 0.02, `${most} m`);
    },
  },
  {
    effect: 'waves',
    fact: 'waves go on where no body is left, and come to rest',
    run: async () => {
      const w = await world();
      const pool = addPool(w, { waves: true, waveDamping: 2 });
      const stone = addBody(w, { mass: 2000, geometry: [box(1)], position: [0, 0.6, 0] });
      w.advance(0.5);
      stone.remove();
      w.step();
      const { surface: shown } = pool as WaterVolumeNode;
      assert.ok(highest(shown!.heights) > 0.01, 'it makes waves');
      w.advance(20);
      assert.ok(highest((pool as WaterVolumeNode).surface!.heights) < 1e-3, 'they come to rest');
    },
  },
];
