import { applyInertia } from '../../../../physics-core/dynamics/inertia.js';
import { dot } from '../../../../physics-core/base/math.js';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  below,
  box,
  close,
  fact,
  spin,
  WEIGHTLESS,
  world,
  type Body,
} from '../../helpers.js';

/** Joules. */
const energyOf = (body: Body): number => dot(spin(body), applyInertia(body, spin(body))) / 2;

const UNDAMPED = { linearDampingFactor: 0, angularDampingFactor: 0 };

for (const accuracy of levelNames)
  fact(
    `at ${accuracy} a needle that turns farther in a step than Bullet can gains no energy`,
    async () => {
      const w = await world({ ...WEIGHTLESS, accuracy });
      const needle = addBody(w, {
        geometry: [box(4, 0.01, 0.01)],
        angularVelocity: [2 / w.timeStep, 9, 7],
        ...UNDAMPED,
      });
      w.step(0);
      const before = energyOf(needle);
      let most = 0;
      for (let i = 0; i < 300; i++) {
        w.step();
        most = Math.max(most, energyOf(needle));
      }
      below(most, before * 1.01, 'J');
    },
  );

fact('moments that no body has, as authors may write them, give no energy either', async () => {
  for (const accuracy of levelNames) {
    const w = await world({ ...WEIGHTLESS, accuracy });
    // One is larger than both others together.
    const body = addBody(w, {
      inertia: [1, 0, 0, 0, 0.0285, 0, 0, 0, 0.123],
      angularVelocity: [12, 24, 6],
      ...UNDAMPED,
    });
    w.step(0);
    const before = energyOf(body);
    for (let i = 0; i < 2 / w.timeStep; i++) {
      w.step();
      // At `game` it was 80 times as much.
      close(energyOf(body), before, 0.02 * before, 'J');
    }
  }
});

fact(
  'an open mesh whose enclosed volume is an accident has moments that a body can have',
  async () => {
    const height = [-0.2, 0.5, 0, 0.5, -0.4, 0, 0, -0.5, -0.2];
    for (const sign of [1, -1])
      for (const shift of [0, 0.3]) {
        const w = await world(WEIGHTLESS);
        const grid = {
          type: 'ElevationGrid',
          xDimension: 3,
          zDimension: 3,
          height: height.map((y) => sign * y + shift),
        };
        const { moments } = addTo(w, grid).mass;
        const [small, middle, large] = [...moments].sort((a, b) => a - b) as [
          number,
          number,
          number,
        ];
        below(large, (small + middle) * 1.001, 'kg m²');
        close(small, large, large, 'kg m², of one order');
      }
  },
);

const addTo = (w: Awaited<ReturnType<typeof world>>, geometry: object): Body => {
  const body = addBody(w, { fixed: true, geometry: [geometry] });
  w.step(0);
  return body;
};
