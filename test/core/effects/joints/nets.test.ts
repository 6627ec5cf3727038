import { describe } from 'node:test';
import type { LevelName } from '../../../../physics-core/inside.js';
import { addBody, below, fact, sphere, world, type Joint } from '../../helpers.js';

/** Metres between the knots of a net. */
const LINK = 0.2;

/** A net of balls in the level, each joined to its neighbours half-way; `held`: the knots that the world holds. */
async function net(accuracy: LevelName, size: number, held: (i: number, k: number) => boolean) {
  const w = await world({ accuracy });
  w.add('CollisionCollection', { collidables: '*', enabled: false });
  const knots = Array.from({ length: size * size }, (_, n) =>
    addBody(w, {
      position: [Math.floor(n / size) * LINK, 0, (n % size) * LINK],
      mass: 0.1,
      geometry: [sphere(0.03)],
    }),
  );
  const joints: Joint[] = [];
  const join = (n: number, other: number | undefined, x: number, z: number): void => {
    joints.push(
      w.add('BallJoint', {
        body1: knots[n],
        ...(other !== undefined && { body2: knots[other] }),
        anchorPoint: [x * LINK, 0, z * LINK],
      }) as Joint,
    );
  };
  for (let i = 0; i < size; i++)
    for (let k = 0; k < size; k++) {
      const n = i * size + k;
      if (i + 1 < size) join(n, n + size, i + 0.5, k);
      if (k + 1 < size) join(n, n + 1, i, k + 0.5);
      if (held(i, k)) join(n, undefined, i, k);
    }
  return { w, widest: () => Math.max(...joints.map(({ gap }) => gap)) };
}

const holds: Record<string, (i: number, k: number) => boolean> = {
  'by one side': (i) => i === 0,
  'by a corner': (i, k) => i + k === 0,
};

describe('nets', () => {
  for (const [by, held] of Object.entries(holds))
    fact(`a net of 8 by 8 that falls, held ${by}, does not gape`, async () => {
      for (const accuracy of ['standard', 'fine'] as const) {
        const { w, widest } = await net(accuracy, 8, held);
        let gap = 0;
        for (let i = 0; i < 60; i++) {
          w.advance(1 / 60);
          gap = Math.max(gap, widest());
        }
        below(gap, 1e-4, `m at ${accuracy}`);
      }
    });

  fact('a net of 20 by 20 that falls, held by one side, does not gape', async () => {
    const { w, widest } = await net('standard', 20, holds['by one side']!);
    let gap = 0;
    for (let i = 0; i < 45; i++) {
      w.advance(1 / 60);
      gap = Math.max(gap, widest());
    }
    below(gap, 1e-4, 'm');
  });
});
