import { FRAME, near, same } from '../checks.js';
import type { Fact } from '../fact.js';
import { allWays, emitterFacts, positionFact, ways } from './emitter-facts.js';
import {
  burst,
  count,
  ends,
  EXACT,
  lengthOf,
  places,
  SAMPLE,
  system,
  unit,
} from './particle-scenes.js';

const FROM = [1, 2, 3];

export const explosionEmitter: Fact[] = [
  {
    field: 'on',
    says: 'all particles are born when it begins, and none after that',
    scene: system(burst({ speed: 2 }), { maxParticles: 50, particleLifetime: 1 }),
    run: async (x) => {
      await x.advance(FRAME);
      const first = await count(x);
      await x.advance(0.9);
      const last = await count(x);
      await x.advance(0.5);
      return [
        same('after a frame', first, 50),
        same('while they live', last, 50),
        same('after that', await count(x), 0),
      ];
    },
  },
  {
    field: 'speed',
    says: 'they go all ways alike, and are on a sphere around where they were born, of v t',
    scene: system(burst({ speed: 2, position: FROM }), { maxParticles: SAMPLE }),
    run: async (x) => {
      await x.advance(0.5);
      const all = ways(await places(x), FROM);
      return [
        near('nearest and furthest', ends(all.map(lengthOf)), [1, 1], EXACT, 'm'),
        ...allWays(all.map(unit)),
      ];
    },
  },
  ...emitterFacts(burst()),
  positionFact(burst()),
];
