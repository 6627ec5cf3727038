import assert from 'node:assert/strict';
import {
  addBody,
  addJoint,
  below,
  box,
  fact,
  random,
  spin,
  velocity,
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

/** So few bodies may still slip, faster than 1 cm/s; 4 measured. Bullet's iterations keep 300 of them trembling for ever. */
const SLIP = 5;

fact('500 boxes about a ball that a motor turned lie still soon after it stops', async () => {
  const w = await world({ gravity: [0, -9.8, 0] });
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
  const r = random(1);
  const bodies = [ball];
  while (bodies.length <= 500) {
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
  w.advance(3);
  for (let i = 0; i < 5; i++) {
    w.advance(1);
    const moving = bodies.filter((body) => Math.hypot(...velocity(body)) > 0.01);
    below(moving.length, SLIP + 1);
  }
});
