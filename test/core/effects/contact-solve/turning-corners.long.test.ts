import { move } from '../../../../references/mechanism.js';
import { slidingRod } from '../../../../references/sliding-rod.js';
import {
  above,
  addBody,
  addFloor,
  below,
  box,
  distance,
  fact,
  position,
  world,
  type Body,
  type Vec3,
} from '../../helpers.js';
import { G } from './scenes.js';

// What turns about an edge or a corner: where it is after so many frames, against the truth in double precision.

const [WIDTH, HEIGHT] = [0.1, 1];
const LEAN = 0.3;

/** The middle of a board that leans on its lower edge, a pendulum on its head. */
function falling(): (frame: number) => Vec3 {
  const arm = Math.sqrt(WIDTH ** 2 + HEIGHT ** 2) / 2;
  const at = (angle: number) => [arm * Math.sin(angle), arm * Math.cos(angle)];
  const angle = move(
    {
      places: (lean) => [lean, ...at(lean)],
      inertias: [(WIDTH ** 2 + HEIGHT ** 2) / 12, 1, 1],
      pulls: [0, 0, -G],
    },
    LEAN - Math.atan2(WIDTH, HEIGHT),
    0,
  );
  return (frame) => [...at(angle(frame).at), 0] as Vec3;
}

// On a slope of tan θ = 1/2, which lies flat while gravity leans.
const DOWNHILL: Vec3 = [G / Math.sqrt(5), (-2 * G) / Math.sqrt(5), 0];

/** A box 1 m high on that slope, over its lower edge. */
function tipping(width: number): (frame: number) => Vec3 {
  const [lean, arm] = [Math.atan2(width, 1), Math.hypot(width, 1) / 2];
  const at = (tipped: number) => [
    width / 2 - arm * Math.sin(lean - tipped),
    arm * Math.cos(lean - tipped),
  ];
  const tipped = move(
    {
      places: (angle) => [angle, ...at(angle)],
      inertias: [(width ** 2 + 1) / 12, 1, 1],
      pulls: [0, DOWNHILL[0], DOWNHILL[1]],
    },
    0,
    0,
  );
  return (frame) => [...at(tipped(frame).at), 0] as Vec3;
}

/** The farthest that it was from there, metres. */
function strays(advance: () => void, body: Body, path: (frame: number) => Vec3, frames: number) {
  let most = 0;
  for (let frame = 1; frame <= frames; frame++) {
    advance();
    most = Math.max(most, distance(position(body), path(frame)));
  }
  return most;
}

const rubs = (friction: number) => ({
  collidables: '*',
  appliedParameters: ['FRICTION_COEFFICIENT-2'],
  frictionCoefficients: [friction, friction],
});

for (const [accuracy, most] of [
  ['game', 4e-4],
  ['standard', 1e-4],
  ['fine', 3e-5],
] as const)
  fact(
    `a board that falls over its edge goes as a pendulum on its head, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy });
      addFloor(w);
      const path = falling();
      const board = addBody(w, {
        position: path(0),
        orientation: [0, 0, 1, -LEAN],
        geometry: [box(WIDTH, HEIGHT, 0.6)],
      });
      w.add('CollisionCollection', rubs(1));
      below(
        strays(() => w.step(Math.round(1 / 60 / w.timeStep)), board, path, 30),
        most,
        'm',
      );
    },
  );

fact('a board slides down a wall, and leaves it when it should', async () => {
  const w = await world();
  addFloor(w);
  addBody(w, { fixed: true, position: [-0.5, 2, 0], geometry: [box(1, 4, 4)] });
  const rod = { length: 2, thickness: 0.1, start: LEAN, gravity: G };
  const slides = slidingRod(rod, 64);
  const path = (frame: number): Vec3 => [slides(frame).x, slides(frame).y, 0];
  const board = addBody(w, {
    position: path(0),
    orientation: [0, 0, 1, LEAN],
    geometry: [box(rod.thickness, rod.length, 0.6)],
  });
  w.add('CollisionCollection', rubs(0));
  below(
    strays(() => w.step(Math.round(1 / 60 / w.timeStep)), board, path, 54),
    2e-4,
    'm',
  );
});

for (const accuracy of ['standard', 'fine', 'precise', 'reference'] as const)
  fact(`a box that hardly tips begins to as it should, at ${accuracy}`, async () => {
    const w = await world({ accuracy, gravity: DOWNHILL });
    addFloor(w);
    // What just stands is 0.5 m wide.
    const path = tipping(0.49);
    const tall = addBody(w, { position: path(0), geometry: [box(0.49, 1, 0.6)] });
    w.add('CollisionCollection', rubs(1));
    // What is off at first grows by e^(3.8 t): rounding to 5e-5 m.
    below(
      strays(() => w.step(Math.round(1 / 60 / w.timeStep)), tall, path, 81),
      6e-5,
      'm',
    );
  });

fact('what slides and begins to tip goes on at its speed', async () => {
  const w = await world();
  addFloor(w);
  const tall = addBody(w, { position: [0, 0.5, 0], geometry: [box(0.3, 1, 0.6)] });
  w.add('CollisionCollection', rubs(0.4));
  w.step(5);
  tall.set('linearVelocity', [3, 0, 0]);
  let before = position(tall)[0];
  for (let i = 0; i < 10; i++) {
    w.step();
    const [x] = position(tall);
    above((x - before) / w.timeStep, 3 - (i + 1) * 0.5 * G * w.timeStep, 'm/s');
    before = x;
  }
});
