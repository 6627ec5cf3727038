import { FRAME, holds, near, same } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { box } from '../scenes.js';
import {
  burst,
  count,
  ends,
  EXACT,
  furthest,
  isActive,
  LOOK,
  places,
  point,
  pushes,
  SAMPLE,
  system,
} from './particle-scenes.js';

/** Each tells its age: it goes at 1 m/s along X. */
const clock = point({ speed: 1 });

/** Ten in a second, each for a second. */
const TEN = { maxParticles: 10, particleLifetime: 1 };

const births: Fact[] = [
  {
    field: 'createParticles',
    says: 'FALSE: none is born, and those that there are live on; TRUE: some are, from then on',
    scene: system(clock, { createParticles: false, ...TEN }),
    run: async (x) => {
      await x.advance(LOOK);
      const before = await count(x);
      await x.set('system', 'createParticles', true);
      await x.advance(LOOK);
      const born = await count(x);
      await x.set('system', 'createParticles', false);
      await x.advance(0.5);
      const left = (await places(x)).map(([at]) => at!);
      await x.advance(0.5);
      return [
        same('at first', before, 0),
        same('0.55 s after TRUE', born, 6),
        near('0.5 s after FALSE', left, [0.95, 0.85, 0.75, 0.65, 0.55], EXACT, 'm'),
        same('a second after it', await count(x), 0),
      ];
    },
  },
  {
    field: 'enabled',
    says: 'FALSE: it has no particles; TRUE: it begins anew',
    scene: system(clock, { enabled: false, ...TEN }),
    run: async (x) => {
      await x.advance(LOOK);
      const before = [await count(x), (await isActive(x)) ? 1 : 0];
      await x.set('system', 'enabled', true);
      await x.advance(LOOK);
      const born = (await places(x)).map(([at]) => at!);
      await x.set('system', 'enabled', false);
      await x.advance(FRAME);
      return [
        same('at first it has none, and is not active', before, [0, 0]),
        near('0.55 s after TRUE', born, [0.55, 0.45, 0.35, 0.25, 0.15, 0.05], EXACT, 'm'),
        same('a frame after FALSE', await count(x), 0),
      ];
    },
  },
  {
    field: 'maxParticles',
    says: 'as many live at once, and one comes for each that goes',
    open: 'the n-th is born n times particleLifetime / maxParticles after the first',
    scene: system(clock, TEN),
    run: async (x) => {
      await x.advance(LOOK);
      const first = await count(x);
      await x.advance(1);
      const all = (await places(x)).map(([at]) => at!);
      const expected = [0.95, 0.85, 0.75, 0.65, 0.55, 0.45, 0.35, 0.25, 0.15, 0.05];
      return [same('after 0.55 s', first, 6), near('after 1.55 s', all, expected, EXACT, 'm')];
    },
  },
  {
    field: 'maxParticles',
    says: 'lowered by an event, leaves as many; raised, lets more be born',
    open: 'where it is lowered the oldest go',
    scene: system(clock, TEN),
    run: async (x) => {
      await x.advance(1 + LOOK);
      await x.set('system', 'maxParticles', 4);
      await x.advance(FRAME);
      const few = (await places(x)).map(([at]) => at! - FRAME);
      await x.set('system', 'maxParticles', 40);
      await x.advance(2 + LOOK / 10);
      return [
        near('lowered to 4', few, [0.35, 0.25, 0.15, 0.05], EXACT, 'm'),
        same('raised to 40', await count(x), 40),
      ];
    },
  },
];

const lives: Fact[] = [
  {
    field: 'particleLifetime',
    says: 'is how long each lives; an event acts on those that are born after it',
    scene: system(clock, TEN),
    run: async (x) => {
      await x.advance(1 + LOOK);
      const first = (await places(x))[0]![0]!;
      await x.set('system', 'particleLifetime', 2);
      await x.advance(3 + LOOK);
      const all = (await places(x)).map(([at]) => at!);
      return [
        near('the oldest after 1.55 s', first, 0.95, EXACT, 'm'),
        same('how many at 2 s', all.length, 10),
        holds('the oldest is between 1.8 and 2 s old', all[0]! > 1.8 - EXACT && all[0]! < 2),
        near('from one to the next', all[0]! - all[1]!, 0.2, EXACT, 'm'),
      ];
    },
  },
  {
    field: 'lifetimeVariation',
    says: 'is the greatest share by which a life is longer or shorter; all within it are as likely',
    open: 'lives are spread evenly',
    scene: system(burst({ speed: 1 }), {
      maxParticles: SAMPLE,
      particleLifetime: 1,
      lifetimeVariation: 0.5,
    }),
    run: async (x) => {
      const left: number[] = [];
      for (const seconds of [0.5, 0.25, 0.25, 0.25, 0.25 + FRAME]) {
        await x.advance(seconds);
        left.push((await count(x)) / SAMPLE);
      }
      return [
        near(
          'share after half a life and after one and a half',
          [left[0]!, left[4]!],
          [1, 0],
          0,
          '',
        ),
        near('share after 0.75, 1 and 1.25 s', left.slice(1, 4), [0.75, 0.5, 0.25], 0.063, ''),
      ];
    },
  },
  {
    field: 'lifetimeVariation',
    says: 'of 0 lets all live as long, from an event on',
    scene: system(clock, { maxParticles: 500, particleLifetime: 1, lifetimeVariation: 0.5 }),
    run: async (x) => {
      await x.advance(2 + LOOK);
      const [, mixed] = ends((await places(x)).map(([at]) => at!));
      await x.set('system', 'lifetimeVariation', 0);
      await x.advance(2 + LOOK);
      const all = (await places(x)).map(([at]) => at!);
      return [
        holds('some live beyond a second before', mixed > 1.2),
        near('the oldest after it', ends(all)[1], 1, 0.003, 's'),
      ];
    },
  },
  {
    field: 'isActive',
    says: 'is TRUE while it has particles or will have some, from nothing to nothing',
    scene: system(clock, { enabled: false, ...TEN }),
    run: async (x) => {
      const seen: boolean[] = [];
      const look = async (seconds: number): Promise<void> => {
        await x.advance(seconds);
        seen.push(await isActive(x));
      };
      await look(0.1);
      await x.set('system', 'enabled', true);
      await look(0.1);
      await x.set('system', 'createParticles', false);
      await look(0.5);
      await look(1);
      return [
        holds('not while it is disabled', !seen[0]),
        holds('while particles are born', seen[1]!),
        holds('while those live', seen[2]!),
        holds('not when they have died', !seen[3]),
      ];
    },
  },
];

const force = (vector: number[]): NodeData => ({ type: 'ForcePhysicsModel', force: vector });

const parts: Fact[] = [
  {
    field: 'emitter',
    says: 'is where its particles come from',
    scene: system(point({ position: [1, 2, 3] })),
    run: async (x) => {
      await x.advance(LOOK);
      const all = await places(x);
      return [
        same('named', await x.get('system', 'emitter'), 'emitter'),
        near('off (1, 2, 3)', furthest(all, [1, 2, 3]), 0, EXACT, 'm'),
      ];
    },
  },
  {
    field: 'emitter',
    says: 'NULL bears nothing',
    scene: system(null),
    run: async (x) => {
      await x.advance(LOOK);
      return [same('count', await count(x), 0), same('active', await isActive(x), false)];
    },
  },
  {
    field: 'physics',
    says: 'all of its models act together',
    scene: system(point({ mass: 0.5 }), { physics: [force([1, 0, 0]), force([0, 2, 3])] }),
    run: async (x) => {
      await x.advance(LOOK);
      const off = furthest(await pushes(x), [2, 4, 6]);
      return [near('off (2, 4, 6) m/s²', off, 0, 100 * EXACT, 'm/s²')];
    },
  },
  {
    field: 'physics',
    says: 'without a model particles go straight on, without weight',
    scene: system(point({ mass: 0.5, speed: 2 })),
    run: async (x) => {
      await x.advance(LOOK);
      return [near('acceleration', furthest(await pushes(x), [0, 0, 0]), 0, 100 * EXACT, 'm/s²')];
    },
  },
];

/** Between faces 1 m from where it comes from. */
const walled = (fields: Record<string, unknown>): NodeData[] =>
  system(clock, { physics: [{ type: 'BoundedPhysicsModel', geometry: box(2) }], ...fields });

const size: Fact = {
  field: 'particleSize',
  says: 'is how wide and high each is: in what bounds it, it is held off by half of the smaller, from an event on, too',
  open: 'a particle is a ball as wide as the smaller of its width and height',
  scene: walled({ particleSize: [0.4, 0.2] }),
  run: async (x) => {
    await x.advance(1.25);
    const thick = (await places(x))[0]![0]!;
    await x.set('system', 'particleSize', [0.02, 1]);
    // Another one, that has met nothing by then: born after 1 s.
    await x.advance(1);
    const thin = (await places(x))[10]![0]!;
    const read = await x.get('system', 'particleSize');
    return [
      near('0.2 m', thick, 2 * 0.9 - 1.25, EXACT, 'm'),
      near('0.02 m', thin, 2 * 0.99 - 1.25, EXACT, 'm'),
      near('it reads', read, [0.02, 1], 1e-6, 'm'),
    ];
  },
};

export const particleSystem: Fact[] = [...births, ...lives, ...parts, size];
