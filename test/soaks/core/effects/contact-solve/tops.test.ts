import { cross, dot, length, normalize, scale } from '../../../../../physics-core/base/math.js';
import { axesOf, kineticEnergy } from '../../../../../references/kinetic-energy.js';
import { steadyTop } from '../../../../../references/steady-top.js';
import {
  addBody,
  addFloor,
  below,
  box,
  close,
  distance,
  fact,
  position,
  sphere,
  spin,
  velocity,
  world,
  type Body,
  type Vec3,
  WEIGHTLESS,
} from '../../../../core/helpers.js';
import { G } from '../../../../core/effects/contact-solve/scenes.js';

// What turns about a point of the floor in all directions: its spin, and its momentum, point elsewhere in each step.

const rough = {
  collidables: '*',
  appliedParameters: ['FRICTION_COEFFICIENT-2'],
  frictionCoefficients: [5, 5],
};

/** Twice as fine is four times as exact. */
for (const [accuracy, most] of [
  ['standard', 0.009],
  ['fine', 0.0024],
  ['precise', 6e-4],
] as const)
  fact(
    `a top that leans goes its circle for three seconds while its tip rolls, at ${accuracy}`,
    async () => {
      const [tip, arm, across, about] = [0.05, 0.3, 0.0227, 0.045];
      const steady = steadyTop({ tip, arm, across, about, lean: 0.4, round: 2, gravity: G });
      const w = await world({ accuracy });
      w.set('rest', 'never');
      addFloor(w);
      w.add('CollisionCollection', rough);
      const top = addBody(w, {
        mass: 1,
        inertia: [across, 0, 0, 0, about, 0, 0, 0, across],
        position: steady.path(0),
        orientation: steady.orientation,
        linearVelocity: steady.velocity,
        angularVelocity: steady.spin,
        geometry: [{ ...sphere(tip), translation: [0, -arm, 0] }],
      });
      let strays = 0;
      for (let frame = 1; frame <= 180; frame++) {
        w.step(Math.round(1 / 60 / w.timeStep));
        strays = Math.max(strays, distance(position(top), steady.path(frame / 60)));
      }
      below(strays, most, 'm');
    },
  );

/** Radians by which a tippe top of 2 cm leans at most in three seconds. */
async function leansOf(accuracy: 'game' | 'standard', rate: number): Promise<number> {
  const w = await world({ accuracy });
  const [radius, mass] = [0.02, 0.02];
  const across = (131 / 350) * mass * radius ** 2;
  const about = 0.4 * mass * radius ** 2;
  addFloor(w);
  w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [0.3, 0.3], bounce: 0 });
  const top = addBody(w, {
    mass,
    position: [0, radius, 0],
    orientation: [0, 0, 1, 0.1],
    centerOfMass: [0, -0.003, 0],
    inertia: [across, 0, 0, 0, about, 0, 0, 0, across],
    angularVelocity: [0, rate, 0],
    geometry: [sphere(radius)],
  });
  let leans = 0;
  for (let i = Math.round(3 / w.timeStep); i > 0; i--) {
    w.step(1);
    const [x, , z] = top.pose().q;
    leans = Math.max(leans, Math.acos(1 - 2 * (x * x + z * z)));
  }
  return leans;
}

// A fourth-order Runge-Kutta with Coulomb's friction has 7 and 9 degrees after seven seconds.
for (const accuracy of ['game', 'standard'] as const)
  for (const rate of [60, 90])
    fact(`a tippe top of ${rate} rad/s is too slow to stand up, at ${accuracy}`, async () => {
      const leans = (await leansOf(accuracy, rate)) * (180 / Math.PI);
      close(leans, 6.5, 1.5);
    });

const SIZE = [0.2, 0.6, 1] as const;

/** Of a body of 1 kg, J. */
const energyOf = (body: Body): number =>
  kineticEnergy(body, velocity(body), spin(body), axesOf(body)) + G * position(body)[1];

fact('a box that stands on a corner, spins and falls keeps its energy until it lies', async () => {
  const w = await world();
  addFloor(w);
  w.add('CollisionCollection', rough);
  // One corner lies at 0 0 0, and the middle leans by a quarter over it.
  const half = scale([...SIZE], 0.5);
  const upright: Vec3 = [-Math.sin(0.25), Math.cos(0.25), 0];
  const middle = scale(upright, length(half));
  const about = 3;
  const body = addBody(w, {
    mass: 1,
    position: middle,
    orientation: [...normalize(cross(half, upright)), Math.acos(dot(half, upright) / length(half))],
    linearVelocity: [about * middle[2], 0, -about * middle[0]],
    angularVelocity: [0, about, 0],
    geometry: [box(...SIZE)],
  });
  const before = energyOf(body);
  let off = 0;
  for (let step = 0; step < 36; step++) {
    w.step(1);
    off = Math.max(off, Math.abs(energyOf(body) - before));
  }
  below(off, 2e-4, 'J');
});

fact('what was put to sleep while it turned has no spin when something wakes it', async () => {
  const w = await world(WEIGHTLESS);
  const stone = addBody(w, { mass: 1, angularVelocity: [12, 9, 7], geometry: [box(...SIZE)] });
  w.step(10);
  stone.sleep();
  addBody(w, {
    position: [0, 3, 0],
    linearVelocity: [0, -6, 0],
    geometry: [sphere(0.1)],
    mass: 1e-3,
  });
  w.advance(0.5);
  below(length(spin(stone)), 0.05, 'rad/s');
});
