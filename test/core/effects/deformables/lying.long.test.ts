import assert from 'node:assert/strict';
import { fact, world } from '../../helpers.js';
import { places } from './helpers.js';

for (const friction of [0, 0.5])
  fact(
    `a block of jelly on a floor trembles less and less, at a friction of ${friction}`,
    async () => {
      const w = await world();
      w.add('RigidBody', {
        fixed: true,
        position: [0, -0.5, 0],
        geometry: [{ type: 'Box', size: [4, 1, 4] }],
      });
      const jelly = w.add('SoftBody', {
        geometry: { type: 'Box', size: [1, 0.54, 1], translation: [0, 0.2705, 0] },
        mass: 100,
        youngsModulus: 20000,
        poissonsRatio: 0.3,
        friction,
        damping: 2,
      });
      w.advance(4);
      let most = 0;
      for (let i = 0; i < 60; i++) {
        const before = places(jelly);
        w.advance(1 / 60);
        places(jelly).forEach((at, n) => {
          most = Math.max(most, Math.hypot(...at.map((value, k) => value - before[n]![k]!)));
        });
      }
      assert.ok(most < 0.001, `a point goes ${1000 * most} mm in a frame`);
    },
  );
