import { addBody, close, fact, height, sphere, world } from '../../helpers.js';
import { swing } from '../water/helpers.js';
import { addRope, DOWN, G, LEVELS, line, tie } from './helpers.js';

const STIFFNESS = 5000;

for (const links of [1, 20])
  for (const accuracy of LEVELS)
    fact(
      `of ${links} links, it stretches by F L / S and bobs as long, at ${accuracy}`,
      async () => {
        const w = await world({ accuracy });
        const fields = {
          fixedIndex: [0],
          mass: 1e-3,
          stretchStiffness: STIFFNESS,
        };
        const rope = addRope(w, line(links, 2, [0, 2, 0], DOWN), fields);
        const body = addBody(w, {
          mass: 40,
          position: [0, 0, 0],
          geometry: [sphere(0.1)],
        });
        tie(w, rope, links, { body });
        // Half of the rope weighs on it, too, and a third of it moves along.
        const stretch = ((40 + 1e-3 / 2) * G * 2) / STIFFNESS;
        const { period, most } = swing(w, 4, () => height(body) + stretch);
        const exact = accuracy === 'game' ? 2e-3 : 1e-3;
        close(period / (2 * Math.PI * Math.sqrt(((40 + 1e-3 / 3) * 2) / STIFFNESS)), 1, exact);
        close(most / stretch, 1, 0.01);
      },
    );

fact('a rope that stretches comes to rest where F L / S has it, with its own weight', async () => {
  const w = await world();
  const fields = {
    fixedIndex: [0],
    mass: 2,
    stretchStiffness: STIFFNESS,
    damping: 6,
  };
  const rope = addRope(w, line(20, 2, [0, 2, 0], DOWN), fields);
  const body = addBody(w, {
    mass: 10,
    position: [0, 0, 0],
    geometry: [sphere(0.1)],
    linearDampingFactor: 0.9,
    autoDamp: true,
  });
  tie(w, rope, 20, { body });
  w.advance(40);
  close(-height(body) / ((11 * G * 2) / STIFFNESS), 1, 1e-3);
});
