import { near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { directionFacts, emitterFacts } from './emitter-facts.js';
import {
  chance,
  ends,
  EXACT,
  MANY,
  middle,
  minus,
  places,
  points,
  SAMPLE,
  share,
  system,
  type Vector,
} from './particle-scenes.js';

type Vec3 = [number, number, number];

const SIDES = [2, 4, 6];

/** Corners of a brick of 2 × 4 × 6 m about a place, and its faces by their numbers. */
const corners = ([x, y, z]: Vec3): number[] =>
  [-1, 1].flatMap((i) => [-2, 2].flatMap((j) => [-3, 3].flatMap((k) => [x + i, y + j, z + k])));

const FACES = [
  [0, 1, 3, 2],
  [4, 6, 7, 5],
  [0, 4, 5, 1],
  [2, 3, 7, 6],
  [0, 2, 6, 4],
  [1, 5, 7, 3],
];

/** The faces of the brick whose corners begin at a number. */
const faces = (from = 0): number[] =>
  FACES.flatMap((face) => [...face.map((corner) => from + corner), -1]);

const ORIGIN: Vec3 = [0, 0, 0];
const AWAY: Vec3 = [20, 0, 0];

const brick = (fields = {}): NodeData => ({
  type: 'VolumeEmitter',
  coord: points(corners(ORIGIN)),
  coordIndex: faces(),
  ...fields,
});

/** How far out of a brick, as a share: 1 on its surface. */
const out = (at: Vector, [x, y, z]: Vec3 = ORIGIN): number =>
  Math.max(...minus(at, [x, y, z]).map((value, i) => (2 * Math.abs(value)) / SIDES[i]!));

const within = (list: Vector[], about: Vec3): number =>
  share(list, (at) => out(at, about) < 1 + EXACT);

const volumes: Fact[] = [
  {
    field: 'coord',
    says: 'are the corners of what particles are born in, each volume alike',
    scene: system(brick({ speed: 0 }), MANY),
    run: async (x) => {
      await x.advance(1);
      const all = (await places(x)).slice(0, SAMPLE);
      const squares = all.map((at) => at.map((value, i) => (value / SIDES[i]!) ** 2));
      return [
        near('share inside', within(all, ORIGIN), 1, 0, ''),
        near('middle', middle(all), [0, 0, 0], chance(1.74), 'm'),
        // (v / side)² of what is even from -½ to ½ is 1/12, of variance 1/180.
        near('spread', middle(squares), [1 / 12, 1 / 12, 1 / 12], chance(Math.sqrt(1 / 180)), ''),
      ];
    },
  },
  {
    field: 'coord',
    says: 'is replaced by an event: particles are born where its points are now',
    scene: system(brick({ speed: 0 })),
    run: async (x) => {
      await x.advance(0.55);
      const before = await places(x);
      await x.set('emitter', 'coord', points(corners(AWAY)));
      await x.advance(0.65);
      const after = (await places(x)).slice(-5);
      return [
        near('share within the first', within(before, ORIGIN), 1, 0, ''),
        near('of the new ones within the second', within(after, AWAY), 1, 0, ''),
      ];
    },
  },
  {
    field: 'coordIndex',
    says: 'names the faces that enclose it, and takes events',
    scene: system(brick({ speed: 0, coord: points([...corners(ORIGIN), ...corners(AWAY)]) })),
    run: async (x) => {
      await x.advance(0.55);
      const before = await places(x);
      await x.set('emitter', 'coordIndex', faces(8));
      await x.advance(0.65);
      const after = (await places(x)).slice(-5);
      return [
        near('share within the first', within(before, ORIGIN), 1, 0, ''),
        near('of the new ones within the second', within(after, AWAY), 1, 0, ''),
      ];
    },
  },
];

const internal: Fact[] = [
  {
    field: 'internal',
    says: 'TRUE, the default, bears particles inside',
    scene: system(brick({ speed: 0, internal: true }), MANY),
    run: async (x) => {
      await x.advance(1);
      const all = (await places(x)).slice(0, SAMPLE);
      // Of the volume 1/8 is nearer to the middle than halfway.
      const deep = share(all, (at) => out(at) < 0.5);
      return [near('share in the inner eighth', deep, 1 / 8, chance(0.33), '')];
    },
  },
  {
    field: 'internal',
    says: 'FALSE bears them on the surface, each area alike',
    scene: system(brick({ speed: 0, internal: false }), MANY),
    run: async (x) => {
      await x.advance(1);
      const all = (await places(x)).slice(0, SAMPLE);
      const onX = share(all, ([a]) => Math.abs(Math.abs(a!) - 1) < EXACT);
      return [
        near('how far out', ends(all.map((at) => out(at))), [1, 1], EXACT, ''),
        near('share of both sides along X', onX, 48 / 88, chance(0.5), ''),
      ];
    },
  },
];

export const volumeEmitter: Fact[] = [
  ...volumes,
  ...internal,
  ...emitterFacts(brick()),
  ...directionFacts(brick()),
];
