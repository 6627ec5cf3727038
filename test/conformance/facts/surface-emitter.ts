import { near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { emitterFacts } from './emitter-facts.js';
import {
  chance,
  ends,
  EXACT,
  furthest,
  MANY,
  mean,
  places,
  SAMPLE,
  share,
  system,
  velocities,
  type Vector,
} from './particle-scenes.js';

const HALF = [1, 2, 3];
const brick: NodeData = { type: 'Box', size: [2, 4, 6] };

const emitter = (surface: NodeData, fields = {}): NodeData => ({
  type: 'SurfaceEmitter',
  surface,
  ...fields,
});

/** How far off the brick's surface: of the shares of the way to its sides the greatest is 1. */
const offBrick = (at: Vector): number => Math.max(...at.map((v, i) => Math.abs(v) - HALF[i]!));

/** A square of 2 m that faces against Z. */
const square: NodeData = {
  type: 'IndexedFaceSet',
  coordIndex: [0, 3, 2, 1, -1],
  coord: { type: 'Coordinate', point: [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0] },
};

export const surfaceEmitter: Fact[] = [
  {
    field: 'surface',
    says: 'is what particles are born on, each area alike',
    scene: system(emitter(brick, { speed: 0 }), MANY),
    run: async (x) => {
      await x.advance(1);
      const all = (await places(x)).slice(0, SAMPLE);
      const onX = share(all, ([a]) => Math.abs(Math.abs(a!) - 1) < EXACT);
      const onZ = share(all, ([, , c]) => Math.abs(Math.abs(c!) - 3) < EXACT);
      return [
        near('off the surface', ends(all.map(offBrick)), [0, 0], EXACT, 'm'),
        // Of 88 m² 48 face along X, 16 along Z.
        near('share of both sides along X', onX, 48 / 88, chance(0.5), ''),
        near('share of both sides along Z', onZ, 16 / 88, chance(0.39), ''),
        near('middle', mean(all.map(([, b]) => b!)), 0, chance(1.5), 'm'),
      ];
    },
  },
  {
    field: 'surface',
    says: 'particles go straight away from it, to the side that its faces look to',
    scene: system(emitter(square, { variation: 0, speed: 2 })),
    run: async (x) => {
      await x.advance(0.55);
      const away = furthest(await velocities(x), [0, 0, -2]);
      const all = await places(x);
      const within = share(all, ([a, b]) => a! >= 0 && a! <= 2 && b! >= 0 && b! <= 2);
      return [
        near('off (0, 0, -2) m/s', away, 0, EXACT, 'm/s'),
        near('share above the square', within, 1, 0, ''),
      ];
    },
  },
  {
    field: 'surface',
    says: 'a closed one sends them outward',
    scene: system(emitter(brick, { variation: 0, speed: 2 }), MANY),
    run: async (x) => {
      await x.advance(0.5);
      const ways = await velocities(x);
      const all = await places(x);
      const far = all.slice(0, 100).map(offBrick);
      const along = ways.slice(0, 100).map((way) => Math.max(...way.map(Math.abs)));
      return [
        near('along one axis', ends(along), [2, 2], EXACT, 'm/s'),
        // Born in the first 0.1 s, and looked at after 0.6.
        near('away from it', ends(far), [1, 1.2], 0.01, 'm'),
      ];
    },
  },
  ...emitterFacts(emitter(brick)),
];
