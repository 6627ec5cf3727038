import type { World } from '../../../../../physics-core/inside.js';
import { levelNames } from '../../../../../physics-core/dynamics/levels.js';
import {
  addBody,
  addFloor,
  below,
  box,
  distance,
  fact,
  height,
  position,
  random,
  sphere,
  world,
  type Body,
} from '../../../../core/helpers.js';

for (const accuracy of levelNames)
  fact(`at ${accuracy} a ball that bounces sinks into no body that it lies on`, async () => {
    const w = await world({ accuracy });
    addFloor(w);
    const slab = addBody(w, { mass: 5, position: [0, 0.5, 0], geometry: [box(2, 1, 2)] });
    const ball = addBody(w, { position: [0, 1.3, 0], geometry: [sphere(0.3)] });
    w.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
    w.advance(3);
    // Bodies without bounce lie 0.1 mm within each other, contactSurfaceThickness; it was 3 to 90 mm.
    below(Math.abs(height(ball) - height(slab) - 0.8), 1.5e-4, 'm');
  });

const RADIUS = 0.3;

/** A hundred balls in a shaft of three balls' width. */
function heap(w: World): Body[] {
  addFloor(w);
  for (const [x, z] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const)
    addBody(w, {
      fixed: true,
      position: [1.5 * x, 6, 1.5 * z],
      geometry: [box(x ? 1 : 4, 12, z ? 1 : 4)],
    });
  const chance = random();
  return Array.from({ length: 100 }, (_, i) => {
    const [column, row] = [(i % 3) - 1, (Math.floor(i / 3) % 3) - 1];
    const x = 0.63 * column + 0.02 * chance();
    const z = 0.63 * row + 0.02 * chance();
    return addBody(w, {
      position: [x, 0.32 + 0.61 * Math.floor(i / 9), z],
      geometry: [sphere(RADIUS)],
    });
  });
}

/** Of any two, metres. */
function greatestOverlap(balls: Body[]): number {
  const places = balls.map(position);
  let greatest = 0;
  places.forEach((a, i) => {
    for (const b of places.slice(0, i)) greatest = Math.max(greatest, 2 * RADIUS - distance(a, b));
  });
  return greatest;
}

fact(
  'a hundred balls in a shaft lie in each other by millimetres, and with bounce by the way of a step',
  async () => {
    // Without bounce they lie after 4 s. With it, where it was 0.26 m, some still fall onto others at 3 m/s.
    for (const [bounce, most] of [
      [0, 0.005],
      [0.5, 3 / 120],
    ] as const) {
      const w = await world();
      const balls = heap(w);
      w.add('CollisionCollection', { collidables: '*', bounce });
      w.advance(4);
      below(greatestOverlap(balls), most, `m, bounce ${bounce}`);
    }
  },
);
