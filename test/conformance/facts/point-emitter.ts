import { near, same } from '../checks.js';
import type { Fact } from '../fact.js';
import { directionFacts, emitterFacts, positionFact } from './emitter-facts.js';
import { EXACT, LOOK, places, point, system } from './particle-scenes.js';

export const pointEmitter: Fact[] = [
  {
    field: 'speed',
    says: 'the n-th particle, born n / 10 s after the first, has gone v times its age',
    scene: system(point({ speed: 2 })),
    run: async (x) => {
      await x.advance(LOOK);
      const xs = (await places(x)).map(([at]) => at!);
      return [
        same('how many', xs.length, 6),
        near('along X, the oldest first', xs, [1.1, 0.9, 0.7, 0.5, 0.3, 0.1], EXACT, 'm'),
      ];
    },
  },
  ...emitterFacts(point()),
  positionFact(point()),
  ...directionFacts(point()),
];
