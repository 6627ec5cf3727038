import { holds, near, same } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import {
  chance,
  count,
  ends,
  EXACT,
  furthest,
  lengthOf,
  LOOK,
  MANY,
  mean,
  middle,
  minus,
  places,
  pushes,
  SAMPLE,
  system,
  unit,
  velocities,
  type Vector,
} from './particle-scenes.js';

// Facts of the fields that several emitters have. They know nothing of where particles are born, but how these go on.

/** Pascal of a wind of 1 m/s (40.4.10). */
export const PRESSURE = 0.64615;

/** How many of the last ones were born since an event, after `renewed`. */
const NEW = 5;

/** Lets at least five more be born: what explodes does so only when it begins anew, and when there is room. */
export async function renewed(x: Driver, emitter: NodeData): Promise<void> {
  if (emitter.type !== 'ExplosionEmitter') return x.advance(LOOK + 0.1);
  await x.set('system', 'createParticles', false);
  await x.advance(10.1);
  await x.set('system', 'createParticles', true);
  await x.advance(0.1);
}

const newest = <T>(list: T[]): T[] => list.slice(-NEW);

const force = (fields = {}): NodeData => ({ type: 'ForcePhysicsModel', ...fields });
const wind = (fields = {}): NodeData => ({ type: 'WindPhysicsModel', gustiness: 0, ...fields });

const on = (emitter: NodeData): Fact => ({
  field: 'on',
  says: 'FALSE bears nothing; TRUE does, from then on; FALSE again, and those that there are go on',
  scene: system({ ...emitter, variation: 0, speed: 2, on: false }),
  run: async (x) => {
    await x.advance(LOOK);
    const off = await count(x);
    await x.set('emitter', 'on', true);
    await x.advance(LOOK);
    const born = await count(x);
    await x.set('emitter', 'on', false);
    await x.advance(LOOK);
    const left = await count(x);
    const speeds = (await velocities(x)).map(lengthOf);
    return [
      same('before', off, 0),
      same('born in 0.55 s', born, emitter.type === 'ExplosionEmitter' ? 100 : 6),
      same('and none after that', left, born),
      near('which still go', ends(speeds), [2, 2], EXACT, 'm/s'),
    ];
  },
});

const speed = (emitter: NodeData): Fact => ({
  field: 'speed',
  says: 'is how fast particles are born, from an event on, too; those that there are stay as fast',
  scene: system({ ...emitter, variation: 0, speed: 2 }),
  run: async (x) => {
    await x.advance(LOOK);
    const first = (await velocities(x)).map(lengthOf);
    await x.set('emitter', 'speed', 3);
    const old = (await velocities(x)).map(lengthOf)[0]!;
    await renewed(x, emitter);
    const second = newest(await velocities(x)).map(lengthOf);
    return [
      near('first', ends(first), [2, 2], EXACT, 'm/s'),
      near('an old one', old, 2, EXACT, 'm/s'),
      near('new ones', ends(second), [3, 3], EXACT, 'm/s'),
    ];
  },
});

const variation = (emitter: NodeData): Fact => ({
  field: 'variation',
  says: 'is the greatest share by which a speed is more or less; all within it are as likely',
  open: 'speeds are spread evenly',
  scene: system({ ...emitter, variation: 0.5, speed: 2 }, MANY),
  run: async (x) => {
    await x.advance(1);
    const speeds = (await velocities(x)).slice(0, SAMPLE).map(lengthOf);
    const [least, most] = ends(speeds);
    return [
      same('how many', speeds.length, SAMPLE),
      holds('none is slower than 1 m/s or faster than 3', least > 1 - EXACT && most < 3 + EXACT),
      near('the slowest and the fastest', [least, most], [1, 3], 0.02, 'm/s'),
      near('mean', mean(speeds), 2, chance(1 / Math.sqrt(3)), 'm/s'),
    ];
  },
});

const variationEvent = (emitter: NodeData): Fact => ({
  field: 'variation',
  says: 'acts on those that are born after an event; with 0 all are as fast',
  scene: system({ ...emitter, variation: 0.5, speed: 2 }),
  run: async (x) => {
    await x.advance(LOOK);
    const [least, most] = ends((await velocities(x)).map(lengthOf));
    await x.set('emitter', 'variation', 0);
    await renewed(x, emitter);
    const after = newest(await velocities(x)).map(lengthOf);
    return [
      holds('they differ', most - least > 0.1),
      near('those after it', ends(after), [2, 2], EXACT, 'm/s'),
    ];
  },
});

const mass = (emitter: NodeData): Fact[] => {
  const physics = [force({ force: [1, 2, -4] })];
  return [
    {
      field: 'mass',
      says: 'of each particle: a force of F makes an acceleration of F / m, from an event on, too',
      scene: system({ ...emitter, mass: 0.5 }, { physics }),
      run: async (x) => {
        await x.advance(LOOK);
        const light = furthest(await pushes(x), [2, 4, -8]);
        await x.set('emitter', 'mass', 2);
        const heavy = furthest(await pushes(x), [0.5, 1, -2]);
        return [
          near('off (2, 4, -8) m/s² at 0.5 kg', light, 0, 100 * EXACT, 'm/s²'),
          near('off (0.5, 1, -2) m/s² at 2 kg', heavy, 0, 100 * EXACT, 'm/s²'),
        ];
      },
    },
    {
      field: 'mass',
      says: 'with 0, the default, no force moves a particle',
      tells: ['idle-force'],
      scene: system({ ...emitter }, { physics }),
      run: async (x) => {
        await x.advance(LOOK);
        return [near('acceleration', furthest(await pushes(x), [0, 0, 0]), 0, 100 * EXACT, 'm/s²')];
      },
    },
  ];
};

const surfaceArea = (emitter: NodeData): Fact => ({
  field: 'surfaceArea',
  says: 'is what the wind pushes on: 0.64615 v² A newtons on each particle, from an event on, too',
  scene: system(
    { ...emitter, mass: 0.5, surfaceArea: 0.1 },
    { physics: [wind({ direction: [0, 0, 1], speed: 5 })] },
  ),
  run: async (x) => {
    const expected = (area: number): Vector => [0, 0, (PRESSURE * 25 * area) / 0.5];
    await x.advance(LOOK);
    const small = furthest(await pushes(x), expected(0.1));
    await x.set('emitter', 'surfaceArea', 0.3);
    const large = furthest(await pushes(x), expected(0.3));
    return [
      near('off 3.23 m/s² with 0.1 m²', small, 0, 100 * EXACT, 'm/s²'),
      near('off 9.69 m/s² with 0.3 m²', large, 0, 100 * EXACT, 'm/s²'),
    ];
  },
});

/** Those of every emitter; `emitter`: one that has somewhere to bear. */
export const emitterFacts = (emitter: NodeData): Fact[] => [
  on(emitter),
  speed(emitter),
  variation(emitter),
  variationEvent(emitter),
  ...mass(emitter),
  surfaceArea(emitter),
];

/** Of those that emit from one point. */
export const positionFact = (emitter: NodeData): Fact => ({
  field: 'position',
  says: 'is where particles are born, from an event on, too; those that there are stay where they are',
  scene: system({ ...emitter, speed: 0, position: [1, 2, 3] }),
  run: async (x) => {
    await x.advance(LOOK);
    const before = await places(x);
    await x.set('emitter', 'position', [-3, 2, 1]);
    await x.advance(0.1);
    const old = (await places(x))[0]!;
    await renewed(x, emitter);
    const after = newest(await places(x));
    return [
      near('off (1, 2, 3)', furthest(before, [1, 2, 3]), 0, EXACT, 'm'),
      near('an old one', old, [1, 2, 3], EXACT, 'm'),
      near('new ones off (-3, 2, 1)', furthest(after, [-3, 2, 1]), 0, EXACT, 'm'),
    ];
  },
});

const direction = (emitter: NodeData): Fact => ({
  field: 'direction',
  says: 'is where particles go, whatever its length, from an event on, too',
  scene: system({ ...emitter, variation: 0, speed: 5, direction: [0, 6, 8] }),
  run: async (x) => {
    await x.advance(LOOK);
    const before = furthest(await velocities(x), [0, 3, 4]);
    await x.set('emitter', 'direction', [-0.1, 0, 0]);
    await renewed(x, emitter);
    const after = furthest(newest(await velocities(x)), [-5, 0, 0]);
    return [
      near('off (0, 3, 4) m/s', before, 0, EXACT, 'm/s'),
      near('new ones off (-5, 0, 0) m/s', after, 0, EXACT, 'm/s'),
    ];
  },
});

/** Whether unit vectors go all ways alike: the means of their shares, and of the squares of these. */
export function allWays(ways: Vector[]) {
  const squares = ways.map((way) => way.map((value) => value * value));
  return [
    near('middle of all ways', middle(ways), [0, 0, 0], chance(1 / Math.sqrt(3)), ''),
    // The variance of a square that is as likely all around is 4/45.
    near('their squares', middle(squares), [1 / 3, 1 / 3, 1 / 3], chance(Math.sqrt(4 / 45)), ''),
  ];
}

const anywhere = (emitter: NodeData): Fact => ({
  field: 'direction',
  says: '0 0 0 sends each particle another way, all ways alike, as fast as the others',
  scene: system({ ...emitter, variation: 0, speed: 5, direction: [0, 0, 0] }, MANY),
  run: async (x) => {
    await x.advance(1);
    const all = (await velocities(x)).slice(0, SAMPLE);
    return [
      near('speeds', ends(all.map(lengthOf)), [5, 5], EXACT, 'm/s'),
      ...allWays(all.map(unit)),
    ];
  },
});

/** Of those that emit one way. */
export const directionFacts = (emitter: NodeData): Fact[] => [
  direction(emitter),
  anywhere(emitter),
];

/** From one point at rest: by how much each has gone. */
export const ways = (list: Vector[], from: Vector): Vector[] =>
  list.map((place) => minus(place, from));
