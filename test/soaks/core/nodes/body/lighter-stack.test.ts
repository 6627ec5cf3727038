import { levelNames } from '../../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  addFloor,
  below,
  box,
  close,
  fact,
  height,
  velocity,
  world,
} from '../../../../core/helpers.js';

for (const accuracy of levelNames)
  fact(`at ${accuracy} boxes that turn ten thousand times lighter stay on their pile`, async () => {
    const w = await world({ accuracy });
    addFloor(w);
    const pile = Array.from({ length: 5 }, (_, i) =>
      addBody(w, { mass: 100, position: [0, 0.5 + i, 0], geometry: [box(1)] }),
    );
    w.advance(1);
    for (const each of pile) each.set('mass', 0.01);
    for (let i = 0; i < 1 / w.timeStep; i++) {
      w.step();
      // 700 m/s with what held them before.
      for (const each of pile) below(Math.hypot(...velocity(each)), 1, 'm/s');
    }
    for (const [i, each] of pile.entries()) close(height(each), 0.5 + i, 5e-3, 'm');
  });
