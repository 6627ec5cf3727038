import { PartMatrix } from '../../../../../physics-core/solver/methods/part-matrix.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  distance,
  fact,
  sphere,
  velocity,
  world,
} from '../../../../core/helpers.js';

// What a matrix costs grows with what hangs together: how many of them a step takes is what large parts cost.

/** Factored in so many steps, for each of them. */
function matricesPerStep(w: World, steps: number): number {
  const { factor } = PartMatrix.prototype;
  let count = 0;
  PartMatrix.prototype.factor = function () {
    count++;
    return factor.call(this);
  };
  for (let i = 0; i < steps; i++) w.step();
  PartMatrix.prototype.factor = factor;
  return count / steps;
}

/** Hinged about Y, in a spiral of two rounds, a little above the floor. */
function spiral(w: World, links: number): void {
  let last: ReturnType<typeof addBody> | undefined;
  let [x, z, turn] = [1, 0, Math.PI / 2];
  for (let i = 0; i <= links; i++) {
    const body = addBody(w, {
      position: [x, 0.3, z],
      orientation: [0, 1, 0, turn],
      mass: 0.5,
      geometry: [box(0.4, 0.2, 0.2)],
    });
    if (last)
      addJoint(w, 'SingleAxisHingeJoint', {
        body1: last,
        body2: body,
        anchorPoint: [x - 0.25 * Math.cos(turn), 0.3, z + 0.25 * Math.sin(turn)],
        axis: [0, 1, 0],
      });
    last = body;
    turn += 0.5 / Math.sqrt((i + 1) * 0.16 + 1);
    x += 0.5 * Math.cos(turn);
    z -= 0.5 * Math.sin(turn);
  }
}

fact('a chain of 50 links that lies on the ground takes less than 18 matrices a step', async () => {
  const w = await world({ gravity: [0, -9.8, 0] });
  addFloor(w);
  spiral(w, 50);
  w.advance(1);
  below(matricesPerStep(w, 240), 18, 'matrices');
});

fact('at `game` it takes at most 8, since it may miss by a few micrometres in a step', async () => {
  const w = await world({ gravity: [0, -9.8, 0], accuracy: 'game' });
  addFloor(w);
  spiral(w, 50);
  w.advance(1);
  below(matricesPerStep(w, 240), 8, 'matrices');
});

fact('what a ball stirs without going anywhere takes none', async () => {
  const w = await world({ gravity: [0, -9.8, 0] });
  addFloor(w);
  for (let x = -3; x <= 3; x++)
    for (let z = -3; z <= 3; z++)
      if (x || z) addBody(w, { position: [x, 0.5, z], geometry: [box(1, 1, 1)] });
  addBody(w, {
    position: [0, 0.5, 0],
    mass: 20,
    angularVelocity: [0, 40, 0],
    geometry: [{ type: 'Sphere', radius: 0.5 }],
  });
  w.advance(0.5);
  below(matricesPerStep(w, 60), 0.01, 'matrices');
});

fact('a ball that only friction holds begins each step with all of it', async () => {
  const w = await world({ gravity: [0, -9.8, 0] });
  // A groove of two inclines, and a moment about Y and along it that friction has to resist.
  for (const side of [-1, 1])
    addBody(w, {
      fixed: true,
      position: [side * 1.5, 0.5, 0],
      orientation: [0, 0, 1, (side * Math.PI) / 4],
      geometry: [box(4, 0.2, 4)],
    });
  const ball = addBody(w, {
    position: [0, -0.15, 0],
    mass: 2,
    torques: [0, 0.2, 0.5],
    autoDisable: false,
    geometry: [sphere(0.5)],
  });
  w.advance(4);
  below(distance(velocity(ball), [0, 0, 0]), 1e-4, 'm/s');
  below(matricesPerStep(w, 60), 0.01, 'matrices');
});
