import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  addJoint,
  below,
  box,
  claim,
  fact,
  position,
  sphere,
  velocity,
  world,
} from '../../helpers.js';

for (const accuracy of levelNames)
  fact(
    `at ${accuracy} a jointed body that a touch wakes within a step keeps to its joint, and is not thrown back to it`,
    async () => {
      const w = await world({ accuracy });
      // A ball on an upright slider, 0.4 m deep in a wall, and a box that falls on it.
      addBody(w, { fixed: true, position: [0.6, 0, 0], geometry: [box(1, 4, 4)] });
      const ball = addBody(w, { geometry: [sphere(0.5)] });
      addJoint(w, 'SliderJoint', { body1: ball, axis: [0, 1, 0] });
      addBody(w, {
        position: [0, 0.7, 0.1],
        linearVelocity: [0, -1, 0],
        geometry: [box(0.5)],
      });
      claim(w, 'initial-overlap');
      let left = 3;
      w.on('afterstep', () => {
        if (left-- > 0) ball.sleep();
      });
      for (let step = 0; step < 6; step++) {
        w.step();
        const [x, , z] = position(ball);
        below(Math.hypot(x!, z!), 1e-4, 'metres from its line');
        // It was 30 m/s to 490 m/s, each level twice as fast.
        below(Math.hypot(...velocity(ball)), 0.5, 'm/s');
      }
    },
  );
