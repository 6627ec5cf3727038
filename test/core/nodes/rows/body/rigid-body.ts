import assert from 'node:assert/strict';
import { conjugate, rotate } from '../../../../../physics-core/base/math.js';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  counts,
  height,
  position,
  sphere,
  spin,
  velocity,
  way,
  world,
  type Vec3,
  WEIGHTLESS,
} from '../../../helpers.js';
import type { Row } from '../row.js';

/** Solid sphere of 1 kg and 0.5 m: 2/5 m r². */
const MOMENT = 0.1;

/** When a sleep rule has put a body to sleep: seconds, looked at every step. */
async function sleepsAfter(
  fields: Record<string, unknown>,
  edit: Record<string, unknown>,
): Promise<number> {
  const w = await world();
  addFloor(w);
  const stone = addBody(w, { geometry: [box(1)], position: [0, 0.5, 0], ...fields });
  w.advance(1);
  assert.equal(stone.sleeping, false, 'awake before the edit');
  for (const [field, value] of Object.entries(edit)) stone.set(field, value);
  const start = w.time;
  while (!stone.sleeping && w.time - start < 3) w.step();
  return w.time - start;
}

const QUIET = {
  autoDisable: true,
  disableTime: 0.5,
  disableLinearSpeed: 0.1,
  disableAngularSpeed: 0.1,
};

export const rows: Row[] = [
  {
    field: 'enabled',
    fact: 'a body taken out hangs still and lets others through, and goes on when it is put back',
    run: async () => {
      const w = await world();
      const shelf = addFloor(w);
      const stone = addBody(w, { position: [0, 0.5, 0] });
      const free = addBody(w, { position: [5, 10, 0] });
      w.advance(0.5);
      const { created } = counts(w);
      free.set('enabled', false);
      shelf.set('enabled', false);
      const at = height(free);
      w.advance(0.5);
      close(height(free), at, 1e-6, 'm, taken out');
      close(height(stone), 0.5 - way(9.8, 0.5), 1e-3, 'm, support taken out');
      free.unset('enabled');
      w.advance(0.5);
      // It kept the 4.9 m/s of its first half second.
      close(height(free), at - 4.9 * 0.5 - way(9.8, 0.5), 1e-3, 'm, put back');
      assert.equal(counts(w).created, created);
    },
  },
  {
    field: 'fixed',
    fact: 'a falling body that becomes fixed stays there, holds others up, and falls from rest when let go',
    run: async () => {
      const w = await world();
      const slab = addBody(w, { position: [0, 5, 0], geometry: [box(4, 1, 4)] });
      const stone = addBody(w, { position: [0, 6, 0] });
      w.advance(0.5);
      slab.set('fixed', true);
      w.step(0);
      const at = height(slab);
      w.advance(1);
      close(height(slab), at, 1e-6, 'm, fixed');
      close(height(stone), at + 1, 2e-3, 'm, resting on it');
      close(velocity(slab), [0, 0, 0], 0, 'm/s, fixed');
      slab.unset('fixed');
      w.advance(0.5);
      close(height(slab), at - way(9.8, 0.5), 1e-3, 'm, let go');
    },
  },
  {
    field: 'mass',
    fact: 'the same force speeds a body of 5 kg up by a fifth: a = F/m',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { forces: [[10, 0, 0]] });
      w.advance(0.5);
      close(velocity(ball), [5, 0, 0], 1e-4, 'm/s at 1 kg');
      ball.set('mass', 5);
      w.advance(0.5);
      close(velocity(ball), [6, 0, 0], 1e-4, 'm/s at 5 kg');
      ball.unset('mass');
      w.advance(0.5);
      close(velocity(ball), [11, 0, 0], 1e-4, 'm/s at 1 kg again');
    },
  },
  {
    field: 'mass',
    fact: 'mass 0 makes a moving body fixed',
    run: async () => {
      const w = await world();
      claim(w, 'zero-mass');
      const ball = addBody(w, { position: [0, 9, 0] });
      w.advance(0.5);
      ball.set('mass', 0);
      w.step(0);
      const at = height(ball);
      w.advance(0.5);
      close(height(ball), at, 1e-6, 'm');
    },
  },
  {
    field: 'inertia',
    fact: 'the same torque turns a body of another inertia at α = I⁻¹ τ, off-diagonal terms included',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const top = addBody(w, { inertia: [1, 0, 0, 0, 1, 0, 0, 0, 2], torques: [[0, 0, 3]] });
      w.advance(0.5);
      close(spin(top), [0, 0, 0.75], 1e-4, 'rad/s at 2 kg·m²');
      top.event('angularVelocity', [0, 0, 0]);
      top.set('inertia', [1, 0, 0, 0, 1, 0, 0, 0, 6]);
      w.advance(0.5);
      close(spin(top), [0, 0, 0.25], 1e-4, 'rad/s at 6 kg·m²');
      // One step, so that it has not turned yet: I = [[2,1,0],[1,2,0],[0,0,1]] has I⁻¹ (3,0,0) = (2,-1,0).
      top.set('torques', [[3, 0, 0]]);
      top.event('angularVelocity', [0, 0, 0]);
      top.event('orientation', [0, 0, 1, 0]);
      top.set('inertia', [2, 1, 0, 1, 2, 0, 0, 0, 1]);
      w.step();
      close(spin(top), [2 / 120, -1 / 120, 0], 1e-5, 'rad/s, oblique tensor');
      top.unset('inertia');
      top.event('angularVelocity', [0, 0, 0]);
      w.step();
      close(spin(top), [3 / MOMENT / 120, 0, 0], 1e-4, "rad/s with the sphere's own");
    },
  },
  {
    field: 'linearVelocity',
    effect: 'free flight',
    fact: 'what is thrown goes v t + ½ g t², not ½ g t dt further',
    run: async () => {
      const w = await world();
      const ball = addBody(w);
      w.step(0);
      ball.set('linearVelocity', [1, 2, 0]);
      w.advance(1);
      close(position(ball), [1, 2 - 4.9, 0], 1e-4, 'm');
    },
  },
  {
    field: 'inertia',
    effect: 'gyroscopic torque',
    fact: 'a free top keeps its angular momentum, and turns over when Euler says: 3.845 s, then every 6.7055 s',
    run: async () => {
      // Moments 1, 2, 3 and (0.05, 3, 0.02) rad/s: the half period 2 K(k) / p of Jacobi's solution.
      const w = await world(WEIGHTLESS);
      const top = addBody(w, { angularVelocity: [0.05, 3, 0.02] });
      w.step(0);
      top.set('inertia', [1, 0, 0, 0, 2, 0, 0, 0, 3]);
      const flips: number[] = [];
      let before = 3;
      for (let i = 0; i < 1320; i++) {
        w.step();
        const [, y] = rotate(conjugate(top.pose().q), spin(top));
        if (y * before < 0) flips.push(w.time);
        before = y;
      }
      close(flips, [3.845, 3.845 + 6.7055], 0.01, 's');
      const inBody = rotate(conjugate(top.pose().q), spin(top)).map((v, i) => v * (i + 1)) as Vec3;
      // 6 kg·m²/s in single precision.
      close(rotate(top.pose().q, inBody), [0.05, 6, 0.06], 2e-5, 'kg·m²/s');
    },
  },
  {
    field: 'centerOfMass',
    fact: 'a spinning body turns about its new centre of mass, which keeps a straight line',
    run: async () => {
      const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
      const ball = addBody(w, { angularVelocity: [0, 0, 2] });
      w.advance(0.25);
      close(position(ball), [0, 0, 0], 1e-6, 'm about its origin');
      ball.event('orientation', [0, 0, 1, 0]);
      ball.set('centerOfMass', [1, 0, 0]);
      w.advance(0.75);
      // The origin stood still at the edit, so the centre moves at ω × (1, 0, 0) = (0, 2, 0).
      const t = 0.75;
      close(
        position(ball),
        [1 - Math.cos(2 * t), 2 * t - Math.sin(2 * t), 0],
        2e-3,
        'm, origin about the centre',
      );
    },
  },
  {
    field: 'massDensityModel',
    fact: 'a density model gives the moment of its own solid: 2/5 m r² of a sphere, 3/10 m r² of a cone',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { torques: [[0, 1, 0]] });
      w.advance(0.1);
      close(spin(ball), [0, 0.1 / MOMENT, 0], 1e-3, 'rad/s, by its geometry');
      const after = async (model: object | null) => {
        ball.set('massDensityModel', model);
        ball.event('angularVelocity', [0, 0, 0]);
        w.advance(0.1);
        return spin(ball)[1];
      };
      close(await after(sphere(2)), 0.1 / 1.6, 1e-4, 'rad/s, sphere of 2 m');
      close(await after(box(3, 1, 1)), 0.1 / (10 / 12), 1e-4, 'rad/s, box');
      close(
        await after({ type: 'Cone', bottomRadius: 2, height: 1 }),
        0.1 / 1.2,
        1e-4,
        'rad/s, cone',
      );
      close(await after(null), 0.1 / MOMENT, 1e-3, 'rad/s, by its geometry again');
    },
  },
  {
    field: 'geometry',
    fact: 'a ball that becomes a larger box rests higher, keeps its Bullet body, and its moment follows',
    run: async () => {
      const w = await world();
      addFloor(w);
      const stone = addBody(w, { position: [0, 0.5, 0] });
      w.advance(1);
      close(height(stone), 0.5, 1e-3, 'm, sphere');
      const { pointer } = stone;
      stone.set('position', [0, 2, 0]);
      stone.set('geometry', [box(2)]);
      w.advance(2);
      close(height(stone), 1, 1e-3, 'm, box');
      assert.equal(stone.pointer, pointer);
      stone.set('forces', [[0, 9.8, 0]]);
      stone.set('torques', [[0, 1, 0]]);
      stone.set('position', [0, 8, 0]);
      stone.event('angularVelocity', [0, 0, 0]);
      stone.event('linearVelocity', [0, 0, 0]);
      w.advance(0.5);
      close(spin(stone)[1], 0.5 / (8 / 12), 1e-3, 'rad/s by m (a² + b²) / 12');
      stone.unset('geometry');
      stone.set('forces', []);
      w.advance(2);
      assert.ok(height(stone) < -1, 'without geometry it falls through');
    },
  },
  {
    field: 'position',
    fact: 'a body that is moved jumps there, keeps its velocity, and comes back when the field is unset',
    run: async () => {
      const w = await world();
      const ball = addBody(w, { position: [1, 1, 1] });
      w.advance(0.5);
      ball.set('position', [3, 20, -2]);
      w.step(0);
      close(position(ball), [3, 20, -2], 1e-6, 'm');
      close(velocity(ball), [0, -4.9, 0], 1e-4, 'm/s');
      w.advance(0.5);
      close(position(ball), [3, 20 - 4.9 * 0.5 - way(9.8, 0.5), -2], 1e-3, 'm, half a second on');
      ball.unset('position');
      w.step(0);
      close(position(ball), [0, 0, 0], 1e-6, 'm, unset');
    },
  },
  {
    field: 'position',
    effect: 'carrying',
    fact: 'a fixed body that is moved along carries what stands on it, and is static again when it stops',
    run: async () => {
      const w = await world();
      const lift = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(4, 1, 4)] });
      const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
      w.advance(0.5);
      // 0.6 m/s along X for a second, as an animation does it: once in two steps. Friction 0.5.
      for (let i = 1; i <= 60; i++) {
        lift.set('position', [0.01 * i, -0.5, 0]);
        w.step(2);
        if (i > 30) close(velocity(stone), [0.6, 0, 0], 0.02, 'm/s, as fast as the lift');
      }
      // It slips until it is as fast, by v² / (2 μ g) = 0.037 m.
      close(position(stone), [0.563, 0.5, 0], 0.01, 'm, carried along');
      assert.equal(lift.body.isStaticObject(), false);
      w.advance(0.5);
      assert.equal(lift.body.isStaticObject(), true);
      close(position(stone), [0.6, 0.5, 0], 0.01, 'm, stopped by sliding as far');
    },
  },
  {
    field: 'orientation',
    fact: 'a turning body that is turned jumps there, keeps its spin and its place',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { position: [4, 0, 0], angularVelocity: [0, 0, 2] });
      w.advance(0.25);
      close(ball.get('orientation') as number[], [0, 0, 1, 0.5], 1e-4, 'rad');
      ball.set('orientation', [0, 0, 1, 1]);
      w.step(0);
      close(ball.get('orientation') as number[], [0, 0, 1, 1], 1e-6, 'rad, turned');
      w.advance(0.25);
      close(ball.get('orientation') as number[], [0, 0, 1, 1.5], 1e-4, 'rad, turning on');
      close(position(ball), [4, 0, 0], 1e-6, 'm');
    },
  },
  {
    field: 'orientation',
    effect: 'carrying',
    fact: 'a fixed table that is turned in each step takes what lies on it round',
    run: async () => {
      const w = await world();
      const table = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(4, 1, 4)] });
      const stone = addBody(w, {
        position: [1, 0.1, 0],
        geometry: [box(0.2)],
        linearVelocity: [0, 0, -1],
        angularVelocity: [0, 1, 0],
      });
      w.step(0);
      for (let i = 1; i <= 240; i++) {
        table.set('orientation', [0, 1, 0, i * w.timeStep]);
        w.step();
      }
      close(position(stone), [Math.cos(2), 0.1, -Math.sin(2)], 3e-4, 'm');
    },
  },
  {
    field: 'linearVelocity',
    fact: 'a velocity that is set carries the body from where it is: x = x₀ + v t',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { linearVelocity: [1, 0, 0] });
      w.advance(0.5);
      ball.set('linearVelocity', [0, 2, -3]);
      w.advance(0.5);
      close(position(ball), [0.5, 1, -1.5], 1e-4, 'm');
    },
  },
  {
    field: 'angularVelocity',
    fact: 'a spin that is set turns the body: angle = ω t',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w);
      w.advance(0.25);
      ball.set('angularVelocity', [0, 3, 0]);
      w.advance(0.5);
      close(ball.get('orientation') as number[], [0, 1, 0, 1.5], 1e-4, 'rad');
    },
  },
  {
    field: 'forces',
    effect: 'forces',
    fact: 'the sum of the forces acts in every step until they are taken away',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { mass: 2 });
      w.advance(0.25);
      ball.set('forces', [
        [3, 1, 0],
        [1, 1, 0],
      ]);
      w.advance(0.5);
      close(velocity(ball), [1, 0.5, 0], 1e-4, 'm/s = F t / m');
      close(position(ball), [way(2, 0.5), way(1, 0.5), 0], 1e-4, 'm');
      ball.unset('forces');
      w.advance(0.5);
      close(velocity(ball), [1, 0.5, 0], 1e-4, 'm/s, without forces');
    },
  },
  {
    effect: 'forces',
    fact: 'applyForce and applyTorque act for one step, off centre with their lever arm',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { mass: 1 });
      ball.applyForce([0, 120, 0], [0.5, 0, 0]);
      ball.applyTorque([12, 0, 0]);
      w.advance(0.5);
      close(velocity(ball), [0, 1, 0], 1e-5, 'm/s = F dt / m');
      close(spin(ball), [0.1 / MOMENT, 0, 0.5 / MOMENT], 1e-3, 'rad/s = τ dt / I');
      ball.set('forces', [[1, 0, 0]]);
      ball.applyForce([119, 0, 0]);
      w.advance(1);
      close(velocity(ball), [1 + 119 / 120, 1, 0], 1e-4, 'm/s, one push on top of a lasting force');
    },
  },
  {
    field: 'torques',
    effect: 'forces',
    fact: 'the sum of the torques acts in every step until they are taken away',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w);
      w.advance(0.25);
      ball.set('torques', [
        [0, 0.1, 0],
        [0, 0.1, 0],
      ]);
      w.advance(0.5);
      close(spin(ball), [0, 1, 0], 1e-4, 'rad/s = τ t / I');
      ball.unset('torques');
      w.advance(0.5);
      close(spin(ball), [0, 1, 0], 1e-4, 'rad/s, without torques');
    },
  },
  {
    field: 'useGlobalGravity',
    fact: 'a falling body freed from gravity keeps its speed',
    run: async () => {
      const w = await world();
      const ball = addBody(w, { position: [0, 50, 0] });
      w.advance(0.5);
      ball.set('useGlobalGravity', false);
      w.advance(0.5);
      close(velocity(ball), [0, -4.9, 0], 1e-4, 'm/s');
      ball.unset('useGlobalGravity');
      w.advance(0.5);
      close(velocity(ball), [0, -9.8, 0], 1e-4, 'm/s, gravity again');
    },
  },
  {
    field: 'autoDamp',
    fact: 'damping acts only while it is switched on: v = v₀ exp(-k t / m)',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, {
        mass: 2,
        linearVelocity: [4, 0, 0],
        linearDampingFactor: 0.5,
        angularDampingFactor: 0,
      });
      w.advance(1);
      close(velocity(ball)[0], 4, 1e-5, 'm/s, not damped');
      ball.set('autoDamp', true);
      w.advance(1);
      close(velocity(ball)[0], 4 * Math.exp(-0.25), 1e-3, 'm/s, damped');
      ball.unset('autoDamp');
      w.advance(1);
      close(velocity(ball)[0], 4 * Math.exp(-0.25), 1e-3, 'm/s, not damped again');
    },
  },
  {
    field: 'linearDampingFactor',
    fact: 'another factor slows by v = v₀ exp(-k t / m)',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { mass: 2, linearVelocity: [4, 0, 0], autoDamp: true });
      w.advance(1);
      close(velocity(ball)[0], 4 * Math.exp(-0.0005), 1e-4, 'm/s at the default of 0.001');
      ball.set('linearDampingFactor', 1);
      const before = velocity(ball)[0];
      w.advance(1);
      close(velocity(ball)[0], before * Math.exp(-0.5), 1e-3, 'm/s at 1');
    },
  },
  {
    field: 'angularDampingFactor',
    fact: 'another factor slows the spin of a ball by ω = ω₀ exp(-k t / I)',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { angularVelocity: [0, 3, 0], autoDamp: true });
      w.advance(1);
      close(spin(ball)[1], 3 * Math.exp(-0.001 / MOMENT), 1e-3, 'rad/s at the default of 0.001');
      ball.set('angularDampingFactor', 0.2);
      const before = spin(ball)[1];
      w.advance(0.5);
      close(spin(ball)[1], before * Math.exp(-1), 1e-3, 'rad/s at 0.2');
    },
  },
  {
    field: 'angularDampingFactor',
    effect: 'axis damping',
    fact: 'where the moments differ, each principal axis slows by its own: ω = ω₀ exp(-k t / I)',
    run: async () => {
      for (const [axis, moment] of [
        [0, 1 / 6],
        [1, 10 / 12],
      ] as const) {
        const w = await world(WEIGHTLESS);
        const omega = [0, 0, 0];
        omega[axis] = 3;
        // m (a² + b²) / 12 with the sides 3, 1, 1.
        const rod = addBody(w, {
          geometry: [box(3, 1, 1)],
          angularVelocity: omega,
          autoDamp: true,
        });
        w.advance(0.5);
        rod.set('angularDampingFactor', 0.5);
        const before = spin(rod)[axis]!;
        w.advance(0.5);
        close(
          spin(rod)[axis]!,
          before * Math.exp(-0.25 / moment),
          2e-3,
          `rad/s about axis ${axis}`,
        );
      }
    },
  },
  {
    field: 'autoDisable',
    effect: 'rest',
    fact: 'a body at rest that may sleep does so after its time, and wakes when it may not',
    run: async () => {
      const w = await world();
      addFloor(w);
      const stone = addBody(w, {
        ...QUIET,
        autoDisable: false,
        geometry: [box(1)],
        position: [0, 0.5, 0],
      });
      w.advance(2);
      assert.equal(stone.sleeping, false);
      stone.set('autoDisable', true);
      w.advance(1);
      assert.equal(stone.sleeping, true);
      assert.equal(stone.body.isActive(), false, 'Bullet does not simulate it');
      stone.set('autoDisable', false);
      w.advance(3);
      assert.equal(stone.sleeping, false);
    },
  },
  {
    field: 'disableTime',
    fact: 'a body sleeps after disableTime, looked at every quarter of a second',
    run: async () => {
      const time = await sleepsAfter({ ...QUIET, disableTime: 100 }, { disableTime: 0.6 });
      // The edit starts the count anew.
      assert.ok(time >= 0.59 && time <= 0.9, `${time} s`);
    },
  },
  {
    field: 'disableLinearSpeed',
    fact: 'a drifting body sleeps once the speed below which it may is above its own',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { ...QUIET, linearVelocity: [0.2, 0, 0] });
      w.advance(2);
      assert.equal(ball.sleeping, false);
      ball.set('disableLinearSpeed', 0.3);
      w.advance(1);
      assert.equal(ball.sleeping, true);
      const at = position(ball);
      w.advance(1);
      close(position(ball), at, 1e-9, 'm, asleep');
    },
  },
  {
    field: 'disableAngularSpeed',
    fact: 'a turning body sleeps once the spin below which it may is above its own',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { ...QUIET, angularVelocity: [0, 0.2, 0] });
      w.advance(2);
      assert.equal(ball.sleeping, false);
      ball.set('disableAngularSpeed', 0.3);
      w.advance(1);
      assert.equal(ball.sleeping, true);
      close(spin(ball), [0, 0, 0], 0, 'rad/s, asleep');
    },
  },
  ...['useFiniteRotation', 'finiteRotationAxis'].map((field): Row => ({
    field,
    fact: `${field} changes nothing: a fast spin is exact with either value`,
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { angularVelocity: [0, 0, 20] });
      const before = counts(w);
      w.advance(0.05);
      close(ball.get('orientation') as number[], [0, 0, 1, 1], 1e-4, 'rad');
      ball.set(field, field === 'useFiniteRotation' ? true : [1, 0, 0]);
      w.advance(0.05);
      close(ball.get('orientation') as number[], [0, 0, 1, 2], 1e-4, 'rad, after the edit');
      assert.deepEqual({ ...counts(w), patched: 0 }, { ...before, patched: 0 });
    },
  })),
  {
    effect: 'full turns',
    fact: 'a ball that turns by most of a turn in a step turns as far as its spin says',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const turn = 1.6 * Math.PI;
      const ball = addBody(w, { angularVelocity: [0, 0, turn / w.timeStep] });
      for (let i = 1; i <= 10; i++) {
        w.step();
        const [, , z, angle] = ball.get('orientation') as [number, number, number, number];
        close(Math.cos(z * angle - turn * i), 1, 1e-6, 'cosine of what is missing');
      }
    },
  },
];
