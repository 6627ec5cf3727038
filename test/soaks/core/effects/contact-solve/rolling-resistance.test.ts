import {
  addBody,
  addFloor,
  box,
  close,
  fact,
  sphere,
  spin,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';
import type { World } from '../../../../../physics-core/inside.js';

// What rolls alone goes on. In a heap, more than 24 that are near each other and touch something, what is slow is braked by the
// moment of its load on an arm of a hundredth of its radius of gyration, and so is what rolled out of one.

const G = 9.8;
const RADIUS = 0.2;
/** Of a ball, metres. */
const GYRATION = Math.sqrt(0.4) * RADIUS;
/** The moment, over mass, m²/s². */
const MOMENT = 0.01 * GYRATION * G;
/** How that brakes what turns about its middle, rad/s², and what rolls, m/s². */
const SPIN_BRAKE = MOMENT / GYRATION ** 2;
const BRAKE = (MOMENT * RADIUS) / (GYRATION ** 2 + RADIUS ** 2);

/** Of `standard`, seconds; nothing presses before the first one. */
const STEP = 1 / 120;

const scene = async (): Promise<World> => {
  const w = await world({ gravity: [0, -G, 0] });
  addFloor(w);
  return w;
};

/** So many balls side by side that roll the same way, m/s. */
const row = (w: World, count: number, speed: number, gap = 0.01): Body[] =>
  Array.from({ length: count }, (_, i) =>
    addBody(w, {
      position: [i * (2 * RADIUS + gap), RADIUS, 0],
      linearVelocity: [0, 0, speed],
      angularVelocity: [speed / RADIUS, 0, 0],
      geometry: [sphere(RADIUS)],
    }),
  );

const forward = (body: Body): number => velocity(body)[2];

fact('24 balls near each other roll on', async () => {
  const w = await scene();
  const balls = row(w, 24, 0.1);
  w.advance(3);
  for (const ball of balls) close(forward(ball), 0.1, 1e-4);
});

fact('a heap of 30 balls that roll slowly comes to a stop', async () => {
  const w = await scene();
  const balls = row(w, 30, 0.1);
  w.advance(1);
  for (const ball of balls) close(forward(ball), 0.1 - BRAKE, 5e-4);
  w.advance(2);
  for (const ball of balls) close(forward(ball), 0, 1e-6);
});

fact('in a heap, too, what is faster than 0.5 m/s rolls on', async () => {
  const w = await scene();
  const balls = row(w, 30, 0.6);
  w.advance(3);
  for (const ball of balls) close(forward(ball), 0.6, 1e-3);
});

fact('what rolled out of a heap comes to a stop as in it', async () => {
  const w = await scene();
  const [first, ...others] = row(w, 30, 0.1);
  w.advance(0.5);
  for (const ball of others) ball.remove();
  w.advance(0.5);
  close(forward(first!), 0.1 - BRAKE, 5e-4);
  w.advance(2);
  close(forward(first!), 0, 1e-6);
});

fact('what flew out of one and was in the air for more than a second rolls on', async () => {
  const w = await scene();
  const [first] = row(w, 30, 0.1);
  w.advance(0.5);
  const at = forward(first!);
  first!.set('linearVelocity', [-2, 8, at]);
  w.advance(2.5);
  const landed = forward(first!);
  w.advance(1);
  close(forward(first!), landed, 1e-3);
});

fact('a heap in which something is fast is braked the same', async () => {
  const w = await scene();
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0, 0] });
  const balls = row(w, 30, 0.1, -5e-5);
  // Without friction it glides along the first of them, and they turn where they are.
  const plate = addBody(w, {
    position: [-RADIUS - 0.01, 0.2, 0],
    linearVelocity: [0, 0, 0.5],
    geometry: [box(0.02, 0.4, 4)],
  });
  w.advance(0.3);
  close(forward(plate), 0.5, 1e-3);
  for (const ball of balls) close(spin(ball)[0], 0.1 / RADIUS - (0.3 - STEP) * SPIN_BRAKE, 1e-3);
});
