import { chainMasses, slowestSwing, swungChain } from '../../../../references/hanging-chain.js';
import {
  above,
  addBody,
  below,
  close,
  fact,
  height,
  sphere,
  world,
  type Vec3,
} from '../../helpers.js';
import { swing } from '../water/helpers.js';
import { addRope, DOWN, energyOf, G, LEVELS, line, place, places, tie } from './helpers.js';

// ---- a chain that hangs ------------------------------------------------------------------------------------------------

for (const accuracy of LEVELS)
  fact(
    `a hanging chain swings with its own period and keeps doing so, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy });
      const rope = addRope(w, swungChain(40, 2, 0.01), { fixedIndex: [0] });
      const { period, most } = swing(w, 10, () => place(rope, 40)[0]);
      close(period / ((2 * Math.PI) / Math.sqrt(slowestSwing(40, 2, G).square)), 1, 2e-4);
      close(most / 0.01, 1, 0.01);
    },
  );

fact('the finer the level, the nearer its period', async () => {
  const right = (2 * Math.PI) / Math.sqrt(slowestSwing(10, 2, G).square);
  let before = Infinity;
  for (const accuracy of LEVELS) {
    const w = await world({ accuracy });
    const rope = addRope(w, swungChain(10, 2, 0.01), { fixedIndex: [0] });
    const { period } = swing(w, 5, () => place(rope, 10)[0]);
    const off = Math.abs(period / right - 1);
    below(off, before, accuracy);
    before = off;
  }
});

for (const accuracy of LEVELS)
  fact(`a rope that swings from 30 degrees keeps its energy, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    const along: Vec3 = [0.5, -Math.sqrt(0.75), 0];
    const rope = addRope(w, line(40, 2, [0, 0, 0], along), { fixedIndex: [0] });
    const weights = chainMasses(40, 1);
    let last = [places(rope)];
    let [most, widest] = [0, 0];
    for (let i = 0; i < 10 / w.timeStep; i++) {
      w.step();
      last = [...last.slice(-2), places(rope)];
      if (last.length < 3) continue;
      const energy = energyOf(last, weights, w.timeStep);
      most = Math.max(most, Math.abs(energy + G * Math.sqrt(0.75)));
      widest = Math.max(widest, -place(rope, 40)[0]);
    }
    above(widest, 0.9);
    // Of what it has at its lowest.
    below(most / (G * (1 - Math.sqrt(0.75))), 5e-3);
  });

// ---- heavy ends --------------------------------------------------------------------------------------------------------

for (const accuracy of LEVELS)
  fact(`an end 20,000 times heavier than a link hangs at its length, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    const rope = addRope(w, line(40, 2, [0, 0, 0], DOWN), { fixedIndex: [0] });
    const body = addBody(w, { mass: 500, position: [0, -2, 0], geometry: [sphere(0.1)] });
    tie(w, rope, 40, { body });
    w.advance(3);
    close(place(rope, 40), [0, -2, 0], 1e-5);
    close(height(body), -2, 1e-5);
  });
