import { applyInertia } from '../../../../../physics-core/dynamics/inertia.js';
import { dot } from '../../../../../physics-core/base/math.js';
import {
  addBody,
  addFloor,
  below,
  box,
  claim,
  codes,
  fact,
  random,
  spin,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
} from '../../../../core/helpers.js';

// What begins inside another comes out of it, and that is no motion.

const energyOf = (body: Body): number => {
  const [v, w] = [velocity(body), spin(body)];
  return (body.mass.mass * dot(v, v) + dot(w, applyInertia(body, w))) / 2;
};

const next = random(7);
const between = (): number => 2 * next() - 1;
const three = (size = 1): number[] => [size * between(), size * between(), size * between()];

for (const accuracy of ['game', 'standard', 'precise'] as const)
  fact(
    `thin boards that tumble inside a slab leave it with no more energy, at ${accuracy}`,
    async () => {
      for (let i = 0; i < 20; i++) {
        const w = await world({ accuracy, ...WEIGHTLESS });
        addFloor(w);
        const [x, z] = [between(), between()];
        const board = addBody(w, {
          position: [x, -0.3 + 0.2 * between(), z],
          orientation: [...three(), 3 * next()],
          geometry: [box(2.8, 0.02, 0.26)],
          linearVelocity: three(),
          angularVelocity: three(4),
        });
        w.step(0);
        const before = energyOf(board);
        let most = 0;
        for (let step = 0; step < 40; step++) {
          w.step();
          most = Math.max(most, energyOf(board));
        }
        // Some begin so deep that they leave through the other side.
        claim(w, 'initial-overlap', ...(codes(w).includes('sunk') ? ['sunk'] : []));
        below(most, 2 * before, 'J');
        w.destroy();
      }
    },
  );
