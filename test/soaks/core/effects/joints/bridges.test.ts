import { describe } from 'node:test';
import {
  below,
  addBody,
  box,
  fact,
  position,
  world,
  type Body,
  type Joint,
} from '../../../../core/helpers.js';

const PLANKS = 40;
/** Metres. */
const LENGTH = 0.28;
const SPAN = PLANKS * LENGTH;

/** Planks in the level, each held by a point on both of its sides, as long as the way between both ends. */
async function bridge(accuracy: 'game' | 'standard') {
  const w = await world({ accuracy });
  w.add('CollisionCollection', { collidables: '*', enabled: false });
  const planks: Body[] = [];
  const joints: Joint[] = [];
  for (let i = 0; i <= PLANKS; i++) {
    const last = planks.at(-1);
    const plank =
      i < PLANKS
        ? addBody(w, {
            mass: 2,
            position: [(i + 0.5) * LENGTH, 0, 0],
            geometry: [box(0.9 * LENGTH, 0.1, 2)],
          })
        : undefined;
    for (const z of [-0.9, 0.9])
      joints.push(
        w.add('BallJoint', {
          body1: plank ?? last,
          ...(plank && last && { body2: last }),
          anchorPoint: [i * LENGTH, 0, z],
        }) as Joint,
      );
    if (plank) planks.push(plank);
  }
  return { w, planks, widest: () => Math.max(...joints.map(({ gap }) => gap)) };
}

describe('bridges', () => {
  for (const accuracy of ['game', 'standard'] as const)
    fact(`wide planks between two ends neither gape nor sag at ${accuracy}`, async () => {
      const { w, planks, widest } = await bridge(accuracy);
      let [gap, sag] = [0, 0];
      for (let i = 0; i < 120; i++) {
        w.advance(1 / 60);
        gap = Math.max(gap, widest());
        sag = Math.max(sag, ...planks.map((plank) => -position(plank)[1]));
      }
      below(gap, LENGTH / 1000, 'm');
      below(sag, SPAN / 200, 'm');
    });
});
