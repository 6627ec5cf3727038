import { PartMatrix } from '../../../../../physics-core/solver/methods/part-matrix.js';
import type { CreateOptions } from '../../../../../physics-core/create.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  above,
  below,
  box,
  close,
  fact,
  height,
  position,
  spin,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';

// What stands begins with the impulses that its weight asks for.

/** How deep what is built to touch stands in what bears it, and what falls there, metres. */
const [DEPTH, KEPT] = [6e-6, 1e-5];

/** What single precision rounds heights of some metres by. */
const ROUNDED = 2e-6;

/** Of so many steps. */
function matricesOf(w: World, steps: number): number {
  const { factor } = PartMatrix.prototype;
  let matrices = 0;
  PartMatrix.prototype.factor = function () {
    matrices++;
    return factor.call(this);
  };
  try {
    w.step(steps);
  } finally {
    PartMatrix.prototype.factor = factor;
  }
  return matrices;
}

const speed = (body: Body): number => Math.hypot(...velocity(body), ...spin(body));

/** Bricks in rows, every other one moved by half a brick. */
async function wall(rows: number, columns: number, fields: CreateOptions = {}) {
  const w = await world({ gravity: [0, -9.8, 0], rest: 'never', ...fields });
  addFloor(w);
  const bricks = Array.from({ length: rows * columns }, (_, i) => {
    const row = Math.floor(i / columns);
    return addBody(w, {
      position: [0.4 * (i % columns) + 0.2 * (row % 2), 0.1 + 0.2 * row, 0],
      geometry: [box(0.4, 0.2, 0.2)],
    });
  });
  return { w, bricks };
}

for (const accuracy of ['game', 'standard'] as const)
  fact(`a wall of 300 bricks stands without a matrix, at ${accuracy}`, async () => {
    const { w, bricks } = await wall(15, 20, { accuracy });
    below(matricesOf(w, 30), 1);
    below(Math.max(...bricks.map(speed)), 1e-9, 'm/s');
  });

fact(
  'each row comes down to where contacts bear, as all below it do, in its first step and no farther',
  async () => {
    const { w, bricks } = await wall(15, 4);
    const built = bricks.map(height);
    for (const steps of [1, 60]) {
      w.step(steps);
      for (const [i, brick] of bricks.entries()) {
        const row = Math.floor(i / 4);
        close(height(brick), built[i]! - DEPTH * (row + 1), ROUNDED, 'm');
      }
    }
  },
);

fact('a plank lies on posts anywhere below it, a load on its end', async () => {
  const w = await world({ rest: 'never' });
  addFloor(w);
  for (const x of [-0.9, 0.2, 0.8])
    addBody(w, { position: [x, 0.25, 0], mass: 2, geometry: [box(0.1, 0.5, 0.1)] });
  const plank = addBody(w, { position: [0, 0.55, 0], mass: 3, geometry: [box(2, 0.1, 0.2)] });
  const load = addBody(w, { position: [-0.8, 0.7, 0], mass: 5, geometry: [box(0.2)] });
  below(matricesOf(w, 1), 1);
  w.step(240);
  close(height(plank), 0.55 - 2 * DEPTH, ROUNDED, 'm');
  close(position(load), [-0.8, 0.7 - 3 * DEPTH, 0], ROUNDED, 'm');
});

fact('what has its middle beside what bears it tips over, as it does', async () => {
  const w = await world({ rest: 'never' });
  addFloor(w);
  addBody(w, { position: [0, 0.5, 0], mass: 20, geometry: [box(1)] });
  const plank = addBody(w, { position: [0.6, 1.05, 0], geometry: [box(2, 0.1, 0.2)] });
  w.advance(0.5);
  above(-spin(plank)[2], 0.2, 'rad/s');
});

fact('what its friction alone bears stands on a slope as before', async () => {
  const tilt = Math.PI / 12;
  const gravity = [9.8 * Math.sin(tilt), -9.8 * Math.cos(tilt), 0];
  const { w, bricks } = await wall(1, 1, { gravity });
  w.advance(1);
  close(position(bricks[0]!), [0, 0.1 - KEPT, 0], ROUNDED, 'm');
});
