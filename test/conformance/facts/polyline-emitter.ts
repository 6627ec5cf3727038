import { holds, near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { directionFacts, emitterFacts } from './emitter-facts.js';
import {
  chance,
  ends,
  EXACT,
  lengthOf,
  MANY,
  mean,
  minus,
  places,
  points,
  SAMPLE,
  share,
  system,
  type Vector,
} from './particle-scenes.js';

/** From (0, 0, 0) 1 m along X, then 3 m along Y. */
const CORNER = [0, 0, 0, 1, 0, 0, 1, 3, 0];

const line = (fields = {}): NodeData => ({
  type: 'PolylineEmitter',
  coord: points(CORNER),
  ...fields,
});

/** All stay where they are born. */
const still = (fields = {}): NodeData[] => system(line({ speed: 0, ...fields }), MANY);

const onFirst = ([, y]: Vector): boolean => Math.abs(y!) < EXACT;

/** How far the furthest is from both of its segments. */
const off = (list: Vector[]): number =>
  Math.max(
    ...list.map((at) => {
      const along = Math.min(Math.max(at[0]!, 0), 1);
      const up = Math.min(Math.max(at[1]!, 0), 3);
      return Math.min(lengthOf(minus(at, [along, 0, 0])), lengthOf(minus(at, [1, up, 0])));
    }),
  );

/** The line that an event brings: 4 m along Y, at (0, 0, 5). */
const onLine = ([a, b, c]: [number, number, number]): boolean =>
  Math.hypot(a, c - 5) < EXACT && b > -EXACT && b < 4 + EXACT;

const coord: Fact[] = [
  {
    field: 'coord',
    says: 'particles are born anywhere along the line through its points, each length alike',
    open: 'a long segment bears more than a short one',
    scene: still(),
    run: async (x) => {
      await x.advance(1);
      const all = (await places(x)).slice(0, SAMPLE);
      const [first, second] = [all.filter(onFirst), all.filter((at) => !onFirst(at))];
      return [
        near('off the line', off(all), 0, EXACT, 'm'),
        near('share of the first metre of four', first.length / SAMPLE, 0.25, chance(0.44), ''),
        near('along the first', ends(first.map(([at]) => at!)), [0, 1], 0.05, 'm'),
        near('mean along the second', mean(second.map(([, y]) => y!)), 1.5, chance(0.9, 700), 'm'),
      ];
    },
  },
  {
    field: 'coord',
    says: 'is replaced by an event: particles are born along the new line',
    scene: system(line({ speed: 0 })),
    run: async (x) => {
      await x.advance(0.55);
      const before = await places(x);
      await x.set('emitter', 'coord', points([0, 0, 5, 0, 4, 5]));
      await x.advance(0.65);
      const after = (await places(x)).slice(-5);
      return [
        near('off the first line', off(before), 0, EXACT, 'm'),
        holds(
          'on the second',
          after.every(([a, b, c]) => onLine([a!, b!, c!])),
        ),
      ];
    },
  },
];

const coordIndex: Fact[] = [
  {
    field: 'coordIndex',
    says: 'names the points of each line, with -1 after each: nothing is born between two lines',
    scene: still({
      coord: points([0, 0, 0, 1, 0, 0, 9, 9, 9, 0, 3, 0, 3, 3, 0]),
      coordIndex: [0, 1, -1, 3, 4, -1],
    }),
    run: async (x) => {
      await x.advance(1);
      const all = (await places(x)).slice(0, SAMPLE);
      const on = ([a, b, c]: Vector, y: number, to: number): boolean =>
        Math.hypot(b! - y, c!) < EXACT && a! > -EXACT && a! < to + EXACT;
      return [
        near(
          'on one of them',
          share(all, (at) => on(at, 0, 1) || on(at, 3, 3)),
          1,
          0,
          '',
        ),
        near(
          'on the first',
          share(all, (at) => on(at, 0, 1)),
          0.25,
          chance(0.44),
          '',
        ),
      ];
    },
  },
  {
    field: 'coordIndex',
    says: 'takes events: particles are born along the lines that it names now',
    scene: system(line({ speed: 0, coordIndex: [0, 1, -1] })),
    run: async (x) => {
      await x.advance(0.55);
      const before = await places(x);
      await x.set('emitter', 'coordIndex', [1, 2, -1]);
      await x.advance(0.65);
      const after = (await places(x)).slice(-5);
      return [
        near('on the first', share(before, onFirst), 1, 0, ''),
        near(
          'on the second',
          share(after, (at) => !onFirst(at) && off([at]) < EXACT),
          1,
          0,
          '',
        ),
      ];
    },
  },
];

export const polylineEmitter: Fact[] = [
  ...coord,
  ...coordIndex,
  ...emitterFacts(line()),
  ...directionFacts(line()),
];
