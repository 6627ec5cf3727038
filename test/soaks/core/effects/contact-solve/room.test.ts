import assert from 'node:assert/strict';
import {
  addBody,
  addJoint,
  below,
  box,
  distance,
  fact,
  position,
  random,
  spin,
  world,
} from '../../../../core/helpers.js';

// A ball that a motor turns stirs what falls on it, one box in every frame; then the motor stops, and friction the ball.

const WALLS = [
  [[0, -0.5, 0], box(12, 1, 12)],
  [[0, 10.5, 0], box(12, 1, 12)],
  [[-5.5, 5, 0], box(1, 10, 12)],
  [[5.5, 5, 0], box(1, 10, 12)],
  [[0, 5, -5.5], box(10, 10, 1)],
  [[0, 5, 5.5], box(10, 10, 1)],
] as const;

/** Slower than this the ball stands, rad/s. */
const STANDS = 0.01;

/** Seconds after that within which all are to be asleep; 2 of them they have to be slow; up to 7 measured. */
const ASLEEP = 20;

/** How many, and what falls where: a full room takes a minute, two that are half full as long together. */
const ROOMS = [
  { boxes: 500, seed: 1 },
  { boxes: 250, seed: 3 },
  { boxes: 250, seed: 5 },
];

for (const { boxes, seed } of ROOMS)
  fact(
    `${boxes} boxes about a ball that a motor turned fall asleep soon after it stops, and wake as they lay (${seed})`,
    async () => {
      const w = await world({ gravity: [0, -9.8, 0], rest: 'auto' });
      for (const [at, wall] of WALLS) addBody(w, { fixed: true, position: at, geometry: [wall] });
      const ball = addBody(w, {
        position: [1, 1, 0],
        mass: 20,
        autoDamp: true,
        linearDampingFactor: 0,
        angularDampingFactor: 1,
        geometry: [{ type: 'Sphere', radius: 1 }],
      });
      const motor = addJoint(w, 'MotorJoint', {
        body1: ball,
        motor1Axis: [0, 1, 0],
        axis1Torque: 500,
      });
      const r = random(seed);
      const bodies = [ball];
      while (bodies.length <= boxes) {
        const edge = 0.5 + 0.5 * r();
        bodies.push(
          addBody(w, {
            position: [6 * r() - 3, 8.5, 6 * r() - 3],
            mass: 2 * edge ** 3,
            geometry: [box(edge, edge, edge)],
          }),
        );
        w.advance(1 / 60);
      }
      motor.set('axis1Torque', 0);
      for (let i = 0; Math.hypot(...spin(ball)) > STANDS; i++) {
        assert.ok(i < 60, 'the ball stops within a minute');
        w.advance(1);
      }
      const stands = w.time;
      while (bodies.some(({ sleeping }) => !sleeping)) {
        w.advance(0.5);
        below(w.time - stands, ASLEEP, 's');
      }

      // Nothing was lost of what holds them: awake they stay where they were, but for the one of a hundred that may have slipped.
      const before = bodies.map(position);
      w.set('rest', 'never');
      for (const body of bodies) body.wake();
      w.advance(0.5);
      const moved = bodies
        .map((body, i) => distance(position(body), before[i]!))
        .sort((p, q) => p - q);
      below(moved[Math.floor(0.99 * moved.length)]!, 2e-4, 'm');
      below(moved.at(-1)!, 5e-3, 'm');
    },
  );
