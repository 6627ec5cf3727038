import type { LevelName } from '../../../../physics-core/inside.js';
import { addBody, sphere, world, type Joint } from '../../helpers.js';

/** Metres between the knots of a net. */
export const LINK = 0.2;

/** A net of balls in the level, each joined to its neighbours half-way; `held`: the knots that the world holds. */
export async function net(
  accuracy: LevelName,
  size: number,
  held: (i: number, k: number) => boolean,
) {
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

export const holds: Record<string, (size: number) => (i: number, k: number) => boolean> = {
  'by one side': () => (i) => i === 0,
  'by a corner': () => (i, k) => i + k === 0,
  // Its sides are straight between corners that do not move: it can't even sag.
  'taut, by its four corners': (size) => (i, k) => i % (size - 1) === 0 && k % (size - 1) === 0,
};
