import { world, type Vec3 } from '../../helpers.js';
import assert from 'node:assert/strict';
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
];
