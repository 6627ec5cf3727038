import { addBody, addFloor, close, height, velocity, world } from '../../../helpers.js';
import type { Row } from '../row.js';

const G = 9.81;

export const contactShapeRows: Row[] = [
  {
    effect: 'contact shapes',
    fact: 'a cylinder that rolls keeps its speed',
    run: async () => {
      const w = await world({ gravity: [0, -G, 0] });
      addFloor(w);
      const body = addBody(w, {
        position: [0, 0.3, 0],
        orientation: [0, 0, 1, Math.PI / 2],
        linearVelocity: [0, 0, 0.2],
        angularVelocity: [0.2 / 0.3, 0, 0],
        geometry: [{ type: 'Cylinder', radius: 0.3, height: 1 }],
      });
      w.advance(5);
      close(velocity(body), [0, 0, 0.2], 2e-3, 'm/s');
    },
  },
  {
    effect: 'contact shapes',
    fact: 'a pile of cylinders bears its load from step to step, and does not sink while iterations find it',
    run: async () => {
      // Whoever asks for iterations has Bullet's, which begin with the impulses of the last step.
      const w = await world({ gravity: [0, -G, 0], iterations: 10 });
      addFloor(w);
      const pile = Array.from({ length: 10 }, (_, i) =>
        addBody(w, {
          position: [0, 0.5 + i, 0],
          geometry: [{ type: 'Cylinder', radius: 0.5, height: 1 }],
        }),
      );
      w.advance(1);
      // 4.9 mm; 16 mm where each step begins without the load.
      close(height(pile[9]!), 9.5, 8e-3, 'm');
    },
  },
];
