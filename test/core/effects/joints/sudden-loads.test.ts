import assert from 'node:assert/strict';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  close,
  fact,
  position,
  sphere,
  spin,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
} from '../../helpers.js';

// A load that comes or goes acts on what joints hold from its instant, and velocities are those of the end of a step.

const G = 9.8;
const falling = { gravity: [0, -G, 0] };

/** Balls below each other on ball joints, the first one on a block. */
function addString(w: World, count: number, x = 0) {
  const block = addBody(w, { fixed: true, position: [x, 0, 0], geometry: [box(0.2, 0.2, 0.2)] });
  const balls = Array.from({ length: count }, (_, i) =>
    addBody(w, { position: [x, -(i + 1) / 2, 0], geometry: [sphere(0.1)] }),
  );
  const joints = balls.map((body1, i) =>
    w.add('BallJoint', {
      body1,
      body2: balls[i - 1] ?? block,
      anchorPoint: [x, -(i + 0.5) / 2, 0],
    }),
  );
  return { block, balls, joints };
}

/** Two rods that a hinge holds together, and nothing else. */
function addScissors(w: World) {
  const rods = [-0.5, 0.5].map((x) =>
    addBody(w, { position: [x, 0, 0], mass: 1.5, geometry: [box(1, 0.1, 0.1)] }),
  );
  w.add('SingleAxisHingeJoint', { body1: rods[0], body2: rods[1], axis: [0, 0, 1] });
  return rods;
}

const middle = (bodies: Body[], of: (body: Body) => readonly number[], axis: 0 | 1 | 2): number =>
  bodies.reduce((sum, body) => sum + of(body)[axis]!, 0) / bodies.length;

for (const accuracy of levelNames) {
  for (const [what, letGo] of [
    ['its upper joint goes', ({ joints }) => joints[0]!.remove()],
    ['its upper joint holds another body', ({ joints }) => joints[0]!.set('body1', null)],
    ['the body that it hangs from goes', ({ block }) => block.remove()],
    ['that body is disabled', ({ block }) => block.set('enabled', false)],
    ['that body may move, and falls with it', ({ block }) => block.set('fixed', false)],
  ] as [string, (string: ReturnType<typeof addString>) => void][])
    fact(`a string of balls falls by ½ g t² once ${what}, at ${accuracy}`, async () => {
      const w = await world({ ...falling, accuracy });
      const string = addString(w, 3);
      w.advance(0.5);
      const from = string.balls.map((ball) => position(ball)[1]);
      letGo(string);
      w.advance(0.5);
      string.balls.forEach((ball, i) => close(from[i]! - position(ball)[1], G / 8, 5e-5));
      string.balls.forEach((ball) => close(velocity(ball)[1], -G / 2, 1e-3));
    });

  fact(
    `gravity that changes acts from its instant on what is jointed, at ${accuracy}`,
    async () => {
      const w = await world({ ...falling, accuracy });
      const rods = addScissors(w);
      w.advance(0.25);
      w.set('gravity', [4, 0, 0]);
      w.advance(0.5);
      const before = G / 4;
      close(middle(rods, position, 1), -before * (0.125 + 0.5), 5e-5);
      close(middle(rods, position, 0), 0.5, 5e-5);
      close(middle(rods, velocity, 0), 2, 1e-3);
    },
  );

  fact(`a force that begins acts from its instant on what is jointed, at ${accuracy}`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const rods = addScissors(w);
    w.advance(0.25);
    rods[0]!.set('forces', [[0, 0, 6]]);
    w.advance(0.5);
    close(middle(rods, position, 2), 0.25, 5e-5);
    close(middle(rods, velocity, 2), 1, 1e-3);
    rods[0]!.set('forces', []);
    w.advance(0.5);
    close(middle(rods, position, 2), 0.75, 1e-4);
  });

  fact(`a kick strikes what is jointed at its instant, at ${accuracy}`, async () => {
    const w = await world({ ...falling, accuracy });
    const rods = addScissors(w);
    w.advance(0.25);
    rods[1]!.applyImpulse([0, 0, 3]);
    close(velocity(rods[1]!)[2], 2, 1e-6);
    w.advance(0.5);
    close(middle(rods, position, 2), 0.5, 5e-5);
    close(middle(rods, position, 1), (-G * 0.75 ** 2) / 2, 5e-5);
  });
}

fact('what is jointed and falls shows g t after each step', async () => {
  const w = await world(falling);
  const rods = addScissors(w);
  for (let i = 1; i <= 24; i++) {
    w.step(1);
    for (const rod of rods) close(velocity(rod)[1], -G * i * w.timeStep, 1e-5);
  }
});

fact('a pendulum has the energy that it began with, by the velocities that it shows', async () => {
  const w = await world(falling);
  const rod = addBody(w, { position: [0.5, 0, 0], geometry: [box(1, 0.1, 0.1)] });
  w.add('SingleAxisHingeJoint', { body1: rod, anchorPoint: [0, 0, 0], axis: [0, 0, 1] });
  const about = (1 + 0.01) / 12 + 0.25;
  for (let i = 0; i < 240; i++) {
    w.step(1);
    const energy = (about * spin(rod)[2] ** 2) / 2 + G * position(rod)[1];
    close(energy, 0, 2e-3);
    close(Math.hypot(...velocity(rod)), 0.5 * Math.abs(spin(rod)[2]), 1e-4);
  }
});

fact('who looks at velocities changes nothing', async () => {
  const runs = await Promise.all(
    [false, true].map(async (looks) => {
      const w = await world(falling);
      const { balls } = addString(w, 6);
      balls[5]!.applyImpulse([1, 0, 0.5]);
      for (let i = 0; i < 60; i++) {
        w.step(1);
        if (looks) for (const ball of balls) velocity(ball);
      }
      return balls.flatMap((ball) => [...ball.readPose([])]);
    }),
  );
  assert.deepEqual(runs[0], runs[1]);
});

fact('a ragdoll that lies on the floor shows that it lies', async () => {
  const w = await world(falling);
  addBody(w, { fixed: true, position: [0, -0.55, 0], geometry: [box(10, 1, 10)] });
  const rods = addScissors(w);
  w.advance(1);
  for (const rod of rods) below(Math.hypot(...velocity(rod)), 1e-3, 'm/s');
});

fact(
  'a joint that is gone is no fault when another of the scene is asked for its velocities',
  async () => {
    const w = await world(falling);
    const chains = [addString(w, 2), addString(w, 2, 3)];
    w.step(1);
    // Nobody has asked since joints were numbered.
    chains[0]!.joints[1]!.remove();
    close(velocity(chains[1]!.balls[1]!)[1], 0, 1e-6);
    chains[1]!.joints[1]!.remove();
    w.advance(0.5);
    for (const { balls } of chains) close(velocity(balls[1]!)[1], -G * 0.5, 1e-3);
  },
);
