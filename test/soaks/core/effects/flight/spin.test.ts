import assert from 'node:assert/strict';
import { add, cross, dot, scale } from '../../../../../physics-core/base/math.js';
import { applyInertia } from '../../../../../physics-core/dynamics/inertia.js';
import { levelNames } from '../../../../../physics-core/dynamics/levels.js';
import { MOST_PARTS } from '../../../../../physics-core/solver/tolerances.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  below,
  box,
  claim,
  close,
  fact,
  position,
  spin,
  told,
  velocity,
  WEIGHTLESS,
  world,
  type Body,
  type Vec3,
} from '../../../../core/helpers.js';

// What spins fast: steps are split where joints or an uneven ball make that matter, and turn no body short.

const G = 9.8;

const cylinder = (radius: number, height: number) => ({ type: 'Cylinder', radius, height });

/** A wheel on an arm on a ball joint, set off at its steady precession: its weight by its spin, about the vertical. */
function addGyroscope(w: World, rate: number) {
  const [mass, radius, arm] = [2, 0.5, 1];
  const precession = (mass * G * arm) / (((mass * radius ** 2) / 2) * rate);
  const wheel = addBody(w, {
    mass,
    position: [arm, 0, 0],
    orientation: [0, 0, 1, -Math.PI / 2],
    angularVelocity: [rate, precession, 0],
    linearVelocity: [0, 0, -precession * arm],
    geometry: [cylinder(radius, 0.1)],
  });
  w.add('BallJoint', { body1: wheel, anchorPoint: [0, 0, 0] });
  return { wheel, precession };
}

for (const accuracy of levelNames)
  for (const rate of [60, 300, 1000])
    fact(
      `a wheel of ${rate} rad/s on an arm stays level and goes round by its closed form, at ${accuracy}`,
      async () => {
        const w = await world({ accuracy, gravity: [0, -G, 0] });
        const { wheel, precession } = addGyroscope(w, rate);
        const time = 0.5;
        let strays = 0;
        for (let i = Math.round(time / w.timeStep); i > 0; i--) {
          w.step(1);
          strays = Math.max(strays, Math.abs(position(wheel)[1]));
        }
        const [x, , z] = position(wheel);
        below(strays, 0.005, 'm');
        close(Math.atan2(-z, x) / (precession * time), 1, 0.01);
      },
    );

for (const accuracy of ['game', 'standard'] as const) {
  fact(
    `a blade that a motor drives to 300 rad/s turns about its hinge alone, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy, gravity: [0, -G, 0] });
      const blade = addBody(w, { position: [0, 1, 0], geometry: [box(1, 0.05, 0.1)] });
      w.add('SingleAxisHingeJoint', { body1: blade, anchorPoint: [0, 1, 0], axis: [0, 1, 0] });
      const motor = w.add('MotorJoint', { body1: blade, motor1Axis: [0, 1, 0], axis1Torque: 0 });
      for (let i = Math.round(2 / w.timeStep); i > 0; i--) {
        motor.set('axis1Torque', Math.max(-50, Math.min(50, 5 * (300 - spin(blade)[1]))));
        w.step(1);
      }
      [0, 300, 0].forEach((rate, i) => close(spin(blade)[i]!, rate, 0.5));
    },
  );

  fact(`a blade keeps its 300 rad/s on a free hinge, at ${accuracy}`, async () => {
    const w = await world({ accuracy, gravity: [0, -G, 0] });
    const blade = addBody(w, {
      position: [0, 1, 0],
      angularVelocity: [0, 300, 0],
      geometry: [box(1, 0.05, 0.1)],
    });
    w.add('SingleAxisHingeJoint', { body1: blade, anchorPoint: [0, 1, 0], axis: [0, 1, 0] });
    w.advance(2);
    [0, 300, 0].forEach((rate, i) => close(spin(blade)[i]!, rate, 0.01));
  });

  fact(`a slab and a cube of 300 rad/s turn as far as they spin, at ${accuracy}`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const bodies = [box(1, 1, 1), box(1, 0.2, 0.5)].map((geometry, i) =>
      addBody(w, { position: [3 * i, 0, 0], angularVelocity: [0, 300, 0], geometry: [geometry] }),
    );
    w.advance(0.5);
    for (const body of bodies) close(headingOf(body), turned(150), 1e-3);
  });

  fact(`a car that goes 60 m/s along 400 m of floor loses nothing, at ${accuracy}`, async () => {
    const w = await world({ accuracy, gravity: [0, -G, 0] });
    addFloor(w, 0, { geometry: [box(2000, 1, 20)] });
    const { chassis, wheels } = addCar(w, { at: -200, speed: 60 });
    w.advance(1);
    close(velocity(chassis)[0] / 60, 1, 1e-3);
    for (const wheel of wheels) close((-spin(wheel)[2] * RADIUS) / 60, 1, 1e-3);
    below(Math.abs(position(chassis)[2]), 0.01, 'm');
  });

  fact(
    `wheels of 200 rad/s turn a car about as a rotor of their momentum, at ${accuracy}`,
    async () => {
      const w = await world({ ...WEIGHTLESS, accuracy });
      const { chassis, wheels } = addCar(w, { at: 0, speed: 0, rate: 200, yaw: 1 });
      const bodies = [chassis, ...wheels];
      const before = momentum(bodies);
      const energy = kinetic(bodies);
      w.advance(1);
      const after = momentum(bodies);
      before.forEach((part, i) => close(after[i]!, part, 0.005 * Math.hypot(...before)));
      close(kinetic(bodies) / energy, 1, 0.005);
    },
  );
}

fact('what joints hold and no accuracy can follow says so once, with what they can', async () => {
  const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
  claim(w, 'too-fast');
  const blade = addBody(w, { angularVelocity: [0, 3000, 0], geometry: [box(1, 0.05, 0.1)] });
  w.add('SingleAxisHingeJoint', { body1: blade, axis: [0, 1, 0] });
  w.step(30);
  const [message, ...more] = told(w, 'too-fast');
  assert.match(message!, /3000 rad\/s.* up to 1152 rad\/s .*accuracy="fine"/);
  assert.equal(more.length, 0);
  close(spin(blade)[1], 3000, 30);
});

// ---- what a split step is for everybody else -----------------------------------------------------------------------

/** A world in which something spins that its steps are split for. */
async function splitWorld() {
  const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
  const blade = addBody(w, {
    position: [0, 10, 0],
    angularVelocity: [0, 300, 0],
    geometry: [box(1, 0.05, 0.1)],
  });
  w.add('SingleAxisHingeJoint', { body1: blade, anchorPoint: [0, 10, 0], axis: [0, 1, 0] });
  return w;
}

fact('a force for one step acts in all its parts', async () => {
  const w = await splitWorld();
  const body = addBody(w, { mass: 2 });
  w.step(1);
  body.applyForce([6, 0, 0]);
  w.step(3);
  close(velocity(body)[0], 3 * w.timeStep, 1e-6);
});

fact('a split step is one step for its listeners and for time', async () => {
  const w = await splitWorld();
  const times: number[] = [];
  w.on('beforestep', (detail) => times.push((detail as { time: number }).time));
  const before = w.stepsTaken;
  w.step(5);
  assert.deepEqual(
    times,
    [0, 1, 2, 3, 4].map((n) => n * w.timeStep),
  );
  close(w.time, 5 * w.timeStep, 1e-12);
  const parts = (w.stepsTaken - before) / 5;
  assert.ok(parts > 1 && parts <= MOST_PARTS, `${parts} parts`);
});

fact('a fixed body is carried through a split step to where its author told it to be', async () => {
  const w = await splitWorld();
  const lift = addBody(w, { fixed: true, geometry: [box(1, 1, 1)] });
  const rider = addBody(w, { position: [0, 1.0, 0], geometry: [box(1, 1, 1)], mass: 1 });
  w.on('beforestep', (detail) =>
    lift.set('position', [0, (detail as { time: number }).time + w.timeStep, 0]),
  );
  w.step(60);
  close(position(lift)[1], 1, 1e-6);
  close(velocity(rider)[1], 1, 0.02);
});

fact('what turns little takes its steps whole', async () => {
  const w = await world({ gravity: [0, -G, 0], accuracy: 'standard' });
  addGyroscope(w, 60);
  w.step(10);
  assert.equal(w.stepsTaken, 10);
});

// ---- a car, and what is asked of bodies ----------------------------------------------------------------------------

const RADIUS = 0.3;

function addCar(
  w: World,
  {
    at,
    speed,
    rate = speed / RADIUS,
    yaw = 0,
  }: { at: number; speed: number; rate?: number; yaw?: number },
) {
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.8, 0.8], bounce: 0 });
  const chassis = addBody(w, {
    mass: 800,
    position: [at, 0.5, 0],
    linearVelocity: [speed, 0, 0],
    angularVelocity: [0, yaw, 0],
    geometry: [box(3, 0.4, 1.2)],
  });
  const places = [-1.2, 1.2].flatMap((x) => [-0.75, 0.75].map((z) => [x, z] as const));
  const wheels = places.map(([x, z]) => {
    const wheel = addBody(w, {
      mass: 20,
      position: [at + x, RADIUS, z],
      orientation: [1, 0, 0, Math.PI / 2],
      linearVelocity: [speed + yaw * z, 0, -yaw * x],
      angularVelocity: [0, yaw, -rate],
      geometry: [cylinder(RADIUS, 0.2)],
    });
    const anchorPoint = [at + x, RADIUS, z];
    w.add('SingleAxisHingeJoint', { body1: chassis, body2: wheel, anchorPoint, axis: [0, 0, 1] });
    return wheel;
  });
  return { chassis, wheels };
}

/** kg m²/s about the origin. */
const momentum = (bodies: readonly Body[]): Vec3 =>
  bodies
    .map((body) =>
      add(
        applyInertia(body, spin(body)),
        scale(cross(position(body), velocity(body)), body.mass.mass),
      ),
    )
    .reduce(add);

/** Joules. */
const kinetic = (bodies: readonly Body[]): number =>
  bodies.reduce(
    (sum, body) =>
      sum +
      (dot(spin(body), applyInertia(body, spin(body))) +
        body.mass.mass * dot(velocity(body), velocity(body))) /
        2,
    0,
  );

/** By how far a body is turned about y, radians in [0, 2π). */
function headingOf(body: Body): number {
  const { q } = body.pose();
  return turned(2 * Math.atan2(q[1], q[3]));
}

const turned = (angle: number): number => ((angle % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
