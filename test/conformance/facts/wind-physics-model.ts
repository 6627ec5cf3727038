import { FRAME, holds, near } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import { allWays, PRESSURE } from './emitter-facts.js';
import { modelEnabled } from './force-physics-model.js';
import {
  burst,
  chance,
  dot,
  ends,
  EXACT,
  furthest,
  lengthOf,
  LOOK,
  mean,
  places,
  point,
  pushes,
  SAMPLE,
  system,
  unit,
  type Vector,
} from './particle-scenes.js';

/** Of each particle: 1 m² and 0.1 kg. */
const SAIL = { mass: 0.1, surfaceArea: 1 };

/** m/s² of a wind, m/s, on such a one. */
const push = (speed: number): number => 10 * PRESSURE * speed ** 2;

const READING =
  'a wind of v m/s pushes with 0.64615 v² Pa: the logarithm of the formula in the standard is the decimal one';

const wind = (fields = {}): NodeData => ({
  type: 'WindPhysicsModel',
  DEF: 'model',
  direction: [0, 0, 1],
  gustiness: 0,
  ...fields,
});

const flow = (fields = {}): NodeData[] => system(point(SAIL), { physics: [wind(fields)] });

/** So many at rest in one point. */
const crowd = (count: number, fields = {}): NodeData[] =>
  system(burst({ speed: 0, ...SAIL }), { maxParticles: count, physics: [wind(fields)] });

/** What pushed each particle of a crowd in each of so many frames, from its birth on, m/s². */
async function gusts(x: Driver, frames: number): Promise<Vector[][]> {
  const all: Vector[][] = [];
  let [before, speeds]: [Vector[], Vector[]] = [[], []];
  // They are born at rest where everything is 0.
  const of = (list: Vector[], k: number, axis: number): number => list[k]?.[axis] ?? 0;
  for (let i = 0; i < frames; i++) {
    await x.advance(FRAME);
    const now = await places(x);
    const gust = now.map((at, k) =>
      at.map((value, axis) => {
        const way = value - of(before, k, axis) - of(speeds, k, axis) * FRAME;
        return (2 * way) / FRAME ** 2;
      }),
    );
    speeds = gust.map((push, k) => push.map((a, axis) => of(speeds, k, axis) + a * FRAME));
    before = now;
    all.push(gust);
  }
  return all;
}

/** The wind that pushes so, m/s. */
const windOf = (acceleration: Vector): number =>
  Math.sqrt(lengthOf(acceleration) / (10 * PRESSURE));

/** Positions are good to a ten-millionth, and gusts are found by their differences over a frame. */
const GUST = 0.05;

const direction: Fact[] = [
  {
    field: 'direction',
    says: 'is where the wind pushes to, whatever its length, from an event on, too',
    open: READING,
    scene: flow({ direction: [0, 30, 40], speed: 2 }),
    run: async (x) => {
      const a = push(2);
      await x.advance(LOOK);
      const first = furthest(await pushes(x), [0, 0.6 * a, 0.8 * a]);
      await x.set('model', 'direction', [-0.1, 0, 0]);
      const second = furthest(await pushes(x), [-a, 0, 0]);
      return [
        near('off (0, 15.5, 20.7) m/s²', first, 0, 100 * EXACT, 'm/s²'),
        near('off (-25.8, 0, 0) m/s²', second, 0, 100 * EXACT, 'm/s²'),
      ];
    },
  },
  {
    field: 'direction',
    says: '0 0 0 has it blow another way each time, all ways alike, as strongly',
    open: 'all particles feel the same gust, and a gust lasts a sixtieth of a second',
    scene: crowd(1, { direction: [0, 0, 0], speed: 10 }),
    run: async (x) => {
      const all = (await gusts(x, 240)).map(([only]) => only!);
      // Fewer than means are usually taken of.
      const few = Math.sqrt(SAMPLE / all.length);
      return [
        near('wind', ends(all.map(windOf)), [10, 10], GUST, 'm/s'),
        ...allWays(all.map(unit)).map((check) => ({ ...check, tolerance: check.tolerance! * few })),
      ];
    },
  },
];

const strength: Fact[] = [
  {
    field: 'speed',
    says: 'of the wind: it pushes by its square, from an event on, too',
    open: READING,
    scene: flow({ speed: 2 }),
    run: async (x) => {
      await x.advance(LOOK);
      const weak = furthest(await pushes(x), [0, 0, push(2)]);
      await x.set('model', 'speed', 4);
      const strong = furthest(await pushes(x), [0, 0, push(4)]);
      return [
        near('off 25.8 m/s² at 2 m/s', weak, 0, 100 * EXACT, 'm/s²'),
        near('off 103.4 m/s² at 4 m/s', strong, 0, 100 * EXACT, 'm/s²'),
      ];
    },
  },
  {
    field: 'gustiness',
    says: 'is the greatest share by which the wind is more or less, gust by gust; all within it are as likely',
    open: 'a gust lasts a sixtieth of a second, and gusts are spread evenly',
    scene: crowd(1, { speed: 10, gustiness: 0.5 }),
    run: async (x) => {
      const all = (await gusts(x, 240)).map(([only]) => windOf(only!));
      const [least, most] = ends(all);
      return [
        holds('no gust is below 5 m/s or above 15', least > 5 - GUST && most < 15 + GUST),
        near('the weakest and the strongest', [least, most], [5, 15], 0.3, 'm/s'),
        near('mean', mean(all), 10, chance(5 / Math.sqrt(3), all.length), 'm/s'),
      ];
    },
  },
  {
    field: 'gustiness',
    says: 'of 0, from an event on, lets the wind be steady',
    scene: crowd(1, { speed: 10, gustiness: 0.5 }),
    run: async (x) => {
      await x.advance(0.5);
      await x.set('model', 'gustiness', 0);
      const off = furthest(await pushes(x), [0, 0, push(10)]);
      return [near('off 646 m/s²', off, 0, 1000 * EXACT, 'm/s²')];
    },
  },
];

/** How far each goes off the way of the wind, radians. */
const angles = (all: Vector[]): number[] =>
  all.map((each) => Math.acos(Math.min(1, dot(unit(each), [0, 0, 1]))));

const turbulence: Fact[] = [
  {
    field: 'turbulence',
    says: 'pushes each particle another way, the more of it the further off the wind, as strongly',
    open: 'all ways within π times as much from the direction of the wind are as likely',
    scene: crowd(SAMPLE, { speed: 10, turbulence: 0.25 }),
    run: async (x) => {
      const [all] = await gusts(x, 1);
      const cosines = all!.map((each) => dot(unit(each), [0, 0, 1]));
      const depth = 1 - Math.cos(Math.PI / 4);
      return [
        near('wind', ends(all!.map(windOf)), [10, 10], GUST, 'm/s'),
        near('the furthest off', Math.max(...angles(all!)), Math.PI / 4, 0.02, 'rad'),
        near('mean cosine', mean(cosines), 1 - depth / 2, chance(depth / Math.sqrt(12)), ''),
      ];
    },
  },
  {
    field: 'turbulence',
    says: '1 pushes them all ways alike',
    open: 'all ways within π times as much from the direction of the wind are as likely',
    scene: crowd(SAMPLE, { speed: 10, turbulence: 1 }),
    run: async (x) => {
      const [all] = await gusts(x, 1);
      return allWays(all!.map(unit));
    },
  },
  {
    field: 'turbulence',
    says: 'of 0, the default, from an event on, pushes all the same way',
    scene: crowd(20, { speed: 10, turbulence: 1 }),
    run: async (x) => {
      await x.advance(0.5);
      await x.set('model', 'turbulence', 0);
      const off = furthest(await pushes(x), [0, 0, push(10)]);
      return [near('off 646 m/s²', off, 0, 1000 * EXACT, 'm/s²')];
    },
  },
];

export const windPhysicsModel: Fact[] = [
  ...strength,
  ...direction,
  ...turbulence,
  modelEnabled(flow({ enabled: false, speed: 2 }), [0, 0, push(2)]),
];
