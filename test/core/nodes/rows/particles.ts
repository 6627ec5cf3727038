import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  box,
  close,
  position,
  velocity,
  WEIGHTLESS,
  world,
  type Node,
  type Vec3,
} from '../../helpers.js';
import type { Row } from './row.js';

/** What the effect of particle systems does: their own facts stand beside the effect and the nodes. */
export const particleRows: Row[] = [
  {
    effect: 'particles',
    fact: 'particles are born and fly',
    run: async () => {
      const w = await world();
      const system = w.add('ParticleSystem', {
        emitter: { type: 'PointEmitter', speed: 2, variation: 0 },
      });
      w.advance(0.5);
      const [[, y]] = system.get('positions') as [Vec3];
      assert.ok(Math.abs(y - 1) < 1e-9, `${y}`);
    },
  },
  {
    effect: 'particles',
    fact: 'a wind of a system that pushes takes bodies along, as far as it does at any level',
    run: async () => {
      const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
      const stone = addBody(w, { mass: 2, geometry: [box(1)] });
      w.add('ParticleSystem', {
        maxParticles: 0,
        pushes: true,
        physics: [{ type: 'WindPhysicsModel', direction: [1, 0, 0], speed: 20, gustiness: 0 }],
      });
      const t = w.advance(0.5);
      // du/dt = -k u²
      const k = 0.64615 / 2;
      close(velocity(stone)[0], 20 - 20 / (1 + k * 20 * t), 1e-4, 'm/s');
      close(position(stone)[0], 20 * t - Math.log(1 + k * 20 * t) / k, 1e-4, 'm');
    },
  },
];

const places = (system: Node): Vec3[] => system.get('positions') as Vec3[];
const oldest = (system: Node): Vec3 => places(system)[0]!;
const newest = (system: Node): Vec3 => places(system).at(-1)!;

/** From a metre above the ground. */
const POINT = { position: [0, 1, 0], direction: [0, -1, 0], speed: 2, variation: 0 };

/** One particle each tenth of a second. */
const flow = (w: World, emitter: Record<string, unknown> = {}, fields = {}): Node =>
  w.add('ParticleSystem', {
    emitter: { type: 'PointEmitter', ...POINT, ...emitter },
    maxParticles: 100,
    particleLifetime: 10,
    lifetimeVariation: 0,
    particleSize: [0, 0],
    ...fields,
  });

/** A system that has run for a while, an edit of a field of it, and another while. */
const edited = (
  field: string,
  fact: string,
  make: (w: World) => Node,
  value: unknown,
  judge: (system: Node, w: World) => void,
): Row => ({
  field,
  fact,
  run: async () => {
    const w = await world(WEIGHTLESS);
    const system = make(w);
    w.advance(0.25);
    system.set(field, value);
    w.advance(1);
    judge(system, w);
  },
});

/** Above a floor. */
const rain = (w: World, emitter = {}, fields = {}): Node => {
  addFloor(w);
  return flow(w, emitter, { collides: true, ...fields });
};

const among: Row[] = [
  edited(
    'collides',
    'from an edit on, particles bounce off bodies',
    (w) => rain(w, {}, { collides: false }),
    true,
    (system) => close(oldest(system)[1], 0, 1e-3, 'm'),
  ),
  edited(
    'bounce',
    'is the share of the approach speed that comes back',
    rain,
    0.5,
    // Half a second down, then 0.75 s up at half the speed.
    (system) => close(oldest(system)[1], 0.75, 1e-3, 'm'),
  ),
  edited(
    'friction',
    'of 0 lets what meets the ground go on along it',
    (w) => rain(w, { direction: [1, -1, 0], speed: 2 * Math.SQRT2 }),
    0,
    (system) => close(oldest(system), [2.5, 0, 0], 1e-3, 'm'),
  ),
  edited(
    'pushes',
    'gives a body what its particles lose',
    (w) => {
      addBody(w, { geometry: [box(1)], mass: 1 });
      return flow(w, { position: [0, 2, 0], mass: 0.1 }, { collides: true });
    },
    true,
    (_, w) => {
      const ball = [...w.nodes].find(({ type }) => type.name === 'RigidBody')!;
      assert.ok(velocity(ball)[1] < -0.01, `${velocity(ball)[1]}`);
    },
  ),
];

const own: Row[] = [
  edited(
    'damping',
    'takes so much of its speed from a particle, from an edit on',
    (w) => flow(w),
    2,
    (system) => close(oldest(system)[1], 1 - 0.5 - (1 - Math.exp(-2)), 1e-6, 'm'),
  ),
  {
    field: 'body',
    fact: 'carries the emitter from an edit on',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const cart = addBody(w, { position: [5, 0, 0], linearVelocity: [0, 0, 1] });
      const system = flow(w, { speed: 0 });
      w.advance(0.25);
      system.set('body', cart);
      w.advance(1);
      close(oldest(system), [0, 1, 0], 1e-9, 'm');
      // It has the speed of the body where it is born, so all are as far as that is.
      close(newest(system), [5, 1, 1.25], 1e-3, 'm');
    },
  },
  {
    field: 'seed',
    fact: 'edited, gives the particles that it gives from the start',
    run: async () => {
      const w = await world();
      const wild = { direction: [0, 0, 0] };
      const system = flow(w, wild);
      const [same, other] = [flow(w, wild, { seed: 5 }), flow(w, wild)];
      w.advance(0.25);
      system.set('seed', 5);
      w.advance(1);
      assert.deepEqual(newest(system), newest(same));
      assert.notDeepEqual(newest(system), newest(other));
    },
  },
  {
    field: 'positions',
    fact: 'are where particles are, the oldest first',
    run: async () => {
      const w = await world();
      const system = flow(w);
      w.advance(0.25);
      close(places(system).flat(), [0, 0.5, 0, 0, 0.7, 0, 0, 0.9, 0], 1e-9, 'm');
    },
  },
  {
    field: 'count',
    fact: 'is how many live',
    run: async () => {
      const w = await world();
      const system = flow(w);
      w.advance(0.25);
      assert.equal(system.get('count'), 3);
    },
  },
];

/** Parts that are there before and after: one that is made, or goes, has systems read anew what they are made of, too. */
const takes = (
  field: string,
  type: string,
  fields: Record<string, unknown>,
  judge: (system: Node) => void,
): Row => ({
  field,
  fact: 'another one acts from an edit on',
  run: async () => {
    const w = await world();
    const system = flow(w, {}, { emitter: w.add('PointEmitter', { ...POINT, mass: 0.5 }) });
    const part = w.add(type, fields);
    w.advance(0.25);
    system.set(field, field === 'physics' ? [part] : part);
    w.advance(1);
    judge(system);
  },
});

const parts: Row[] = [
  takes('emitter', 'PointEmitter', { position: [5, 0, 0] }, (system) => {
    close(oldest(system), [0, -1.5, 0], 1e-9, 'm');
    close(newest(system), [5, 0, 0], 1e-9, 'm');
  }),
  takes('physics', 'ForcePhysicsModel', { force: [1, 0, 0] }, (system) =>
    close(oldest(system)[0], 1, 1e-9, 'm'),
  ),
];

export const systemRows: Row[] = [...among, ...own, ...parts];

/** A field of an emitter that is edited when particles are born already. */
const emitterEdit = (
  field: string,
  fields: Record<string, unknown>,
  value: unknown,
  judge: (place: Vec3) => void,
): Row => ({
  field,
  fact: 'an edit acts on those that are born after it',
  run: async () => {
    const w = await world();
    const emitter = w.add(field === 'surface' ? 'SurfaceEmitter' : 'VolumeEmitter', fields);
    const system = flow(w, {}, { emitter });
    w.advance(0.25);
    emitter.set(field, value);
    w.advance(0.5);
    judge(newest(system));
  },
});

const TETRAHEDRON = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const SIDES = [0, 2, 1, -1, 0, 1, 3, -1, 0, 3, 2, -1, 1, 2, 3, -1];

export const surfaceRows: Row[] = [
  emitterEdit('surface', { surface: box(1) }, box(9), (place) =>
    close(Math.max(...place.map(Math.abs)), 4.5, 1e-9, 'm'),
  ),
];

export const volumeRows: Row[] = [
  emitterEdit('internal', { coord: TETRAHEDRON, coordIndex: SIDES }, false, ([x, y, z]) =>
    close(Math.min(x, y, z, 1 - x - y - z), 0, 1e-9, 'm'),
  ),
];
