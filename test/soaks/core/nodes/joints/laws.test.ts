import { describe } from 'node:test';
import { dot, quaternionOf, rotate } from '../../../../../physics-core/base/math.js';
import type { JointNode } from '../../../../../physics-core/nodes/joints/joint.js';
import { turn } from '../../../../../references/turning.js';
import {
  addBody,
  below,
  close,
  distance,
  fact,
  position,
  spin,
  velocity,
  world,
  type Node,
  type Vec3,
  WEIGHTLESS,
} from '../../../../core/helpers.js';

const output = (joint: Node, name: string): number => joint.get(name) as number;
const gapOf = (joint: Node): number => (joint as JointNode).gap;
/** An inertia alike about all axes, so that Bullet's missing gyroscopic torque is none. */
const moments = (m: number): number[] => [m, 0, 0, 0, m, 0, 0, 0, m];

describe('UniversalJoint', () => {
  for (const [beta, tolerance] of [
    [0.3, 1.2e-3],
    [0.6, 5e-3],
    [0.9, 1.3e-2],
  ] as const) {
    fact(`turns a bend of ${beta} rad round: w2 = w1 cos b / (1 - sin² b cos² θ)`, async () => {
      const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
      const shaft = [0, -Math.sin(beta), Math.cos(beta)];
      const driving = addBody(w, { mass: 50, inertia: moments(1e4), angularVelocity: [0, 0, 3] });
      const driven = addBody(w, {
        position: shaft,
        inertia: moments(0.1),
        angularVelocity: shaft.map((c) => (3 * c) / Math.cos(beta)),
      });
      w.add('SingleAxisHingeJoint', { body1: driving, axis: [0, 0, 1] });
      w.add('SingleAxisHingeJoint', { body1: driven, axis: shaft, anchorPoint: shaft });
      w.add('UniversalJoint', {
        body1: driving,
        body2: driven,
        axis1: [1, 0, 0],
        axis2: [0, Math.cos(beta), Math.sin(beta)],
      });
      let worst = 0;
      for (let i = 1; i <= 960; i++) {
        w.step();
        const theta = 3 * w.time;
        const rate = dot(spin(driven), shaft as Vec3);
        const expected = (3 * Math.cos(beta)) / (1 - (Math.sin(beta) * Math.sin(theta)) ** 2);
        worst = Math.max(worst, Math.abs(rate / expected - 1));
      }
      // Half a step of turning, 6 mrad, is that much of the ratio.
      below(worst, tolerance, 'of the rate');
    });
  }
});

describe('SliderJoint', () => {
  fact('a constant force makes x = F t² / 2 m, and the stop sends it back with b v', async () => {
    const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
    const [a, b] = [
      addBody(w, { mass: 2 }),
      addBody(w, { mass: 3, position: [2, -0.1, 0], centerOfMass: [0, 0.1, 0] }),
    ];
    const slider = w.add('SliderJoint', {
      body1: a,
      body2: b,
      axis: [1, 0, 0],
      sliderForce: 6,
      maxSeparation: 1,
      stopBounce: 0.7,
    });
    const reduced = 6 / 5;
    w.advance(0.5);
    close(output(slider, 'separation'), (6 / reduced) * 0.5 ** 2 * 0.5, 1e-6, 'm');
    // It comes to the stop within a step, is thrown back there, and again.
    const pull = 6 / reduced;
    const arrival = Math.sqrt(2 / pull);
    const speed = 0.7 * pull * arrival;
    w.advance(1.5);
    const since = w.time - arrival - (2 * speed) / pull;
    const back = 1 - 0.7 * speed * since + (pull * since ** 2) / 2;
    close(output(slider, 'separation'), back, 2e-5, 'm');
  });
});

describe('DoubleAxisHingeJoint', () => {
  // What spring and damper do in the time of a step is known exactly.
  for (const accuracy of ['game', 'standard', 'fine', 'precise']) {
    fact(`its suspension swings as x'' + 2 ζ ω x' + ω² x = 0 at ${accuracy}`, async () => {
      const w = await world({ ...WEIGHTLESS, accuracy });
      const [wheel, car] = [
        addBody(w, { mass: 20, position: [0, 0, 0] }),
        addBody(w, { mass: 60, position: [0, 1, 0] }),
      ];
      const [force, share] = [0.02, 0.9];
      w.add('DoubleAxisHingeJoint', {
        body1: car,
        body2: wheel,
        axis1: [0, 1, 0],
        axis2: [1, 0, 0],
        suspensionForce: force,
        suspensionErrorCorrection: share,
      });
      w.step();
      car.event('linearVelocity', [0, 0.25, 0]);
      wheel.event('linearVelocity', [0, -0.75, 0]);
      const m = 15;
      const [k, c] = [(60 * share) / force, (1 - share) / force];
      const decay = c / 2 / m;
      const omega = Math.sqrt(k / m - decay * decay);
      let worst = 0;
      for (let t = w.timeStep; t < 1; t += w.timeStep) {
        w.step();
        const x = position(car)[1] - position(wheel)[1] - 1;
        worst = Math.max(worst, Math.abs(x - (Math.exp(-decay * t) * Math.sin(omega * t)) / omega));
      }
      below(worst * omega, 1e-4, 'of the amplitude');
    });
  }

  fact(
    'a motor turns its wheel up to speed in I ω / τ and holds it there, the other body going back',
    async () => {
      const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
      const [car, wheel] = [
        addBody(w, { mass: 5, inertia: moments(2) }),
        addBody(w, { position: [1, 0, 0], inertia: moments(0.5) }),
      ];
      const hinge = w.add('DoubleAxisHingeJoint', {
        body1: car,
        body2: wheel,
        anchorPoint: [1, 0, 0],
        axis1: [0, 1, 0],
        axis2: [1, 0, 0],
        desiredAngularVelocity2: -10,
        maxTorque2: 4,
      });
      // 0.4 kg·m² between them.
      w.advance(0.5);
      close(output(hinge, 'hinge2AngleRate'), -5, 1e-4, 'rad/s, half way');
      w.advance(0.6);
      close(output(hinge, 'hinge2AngleRate'), -10, 1e-5, 'rad/s');
      close([spin(wheel)[0], spin(car)[0]], [8, -2], 1e-5, 'rad/s');
    },
  );
});

/** Complete elliptic integral of the first kind, parameter m = k², by the arithmetic-geometric mean. */
function ellipticK(m: number): number {
  let [a, g] = [1, Math.sqrt(1 - m)];
  while (Math.abs(a - g) > 1e-14) [a, g] = [(a + g) / 2, Math.sqrt(a * g)];
  return Math.PI / 2 / a;
}

describe('a pendulum', () => {
  for (const [type, fields] of [
    ['SingleAxisHingeJoint', { axis: [0, 0, 1] }],
    ['BallJoint', {}],
    ['UniversalJoint', { axis1: [0, 0, 1], axis2: [1, 0, 0] }],
    ['DoubleAxisHingeJoint', { axis1: [0, 0, 1], axis2: [1, 0, 0] }],
  ] as const) {
    fact(`on a ${type} swings from 90 degrees with the period 4 √(I / m g L) K(½)`, async () => {
      const w = await world({ accuracy: 'fine' });
      const rod = addBody(w, {
        position: [0.2, 0, 0],
        centerOfMass: [0.3, 0, 0],
        inertia: moments(0.1),
      });
      const joint = w.add(type, { body1: rod, ...fields });
      const period = 4 * Math.sqrt((0.1 + 0.25) / (9.8 * 0.5)) * ellipticK(0.5);
      const turning: number[] = [];
      for (let i = 0; i < 2400; i++) {
        const before = velocity(rod)[1];
        w.step();
        const now = velocity(rod)[1];
        if (before > 0 && now <= 0) turning.push(w.time + (w.timeStep * now) / (before - now));
      }
      // It turns back at both sides.
      const swings = turning.length - 1;
      close((2 * (turning.at(-1)! - turning[0]!)) / swings / period, 1, 2e-4, 'of the period');
      below(gapOf(joint), 2e-5, 'm, gap');
    });
  }
});

/** Where a top on a ball joint leans to, each 1/60 s: its start and how it turns, for the world and for the truth. */
const top = {
  arm: 0.3,
  lean: quaternionOf([0, 0, 1, -0.6]),
  // Of a disc of 0.5 m radius and 0.1 m height, about its centre.
  moments: [0.19 / 3, 0.125, 0.19 / 3] as Vec3,
};

describe('a top on a ball joint', () => {
  // Half a radian of its own turn per step at game; the error goes with the square of the step (measured, × 1.5).
  for (const [accuracy, tolerance] of [
    ['game', 1.5e-2],
    ['standard', 6e-3],
    ['fine', 1.7e-3],
    ['precise', 4.5e-4],
  ] as const) {
    fact(`nods and goes round as Euler says, at ${accuracy}`, async () => {
      const w = await world({ accuracy, gravity: [0, -9.81, 0] });
      const spinning = rotate(top.lean, [0, 30, 0]);
      const disc = addBody(w, {
        geometry: [],
        inertia: [top.moments[0], 0, 0, 0, top.moments[1], 0, 0, 0, top.moments[2]],
        position: rotate(top.lean, [0, top.arm, 0]),
        orientation: [0, 0, 1, -0.6],
        angularVelocity: spinning,
      });
      w.add('BallJoint', { body1: disc });
      const [across, along] = top.moments;
      const truth = turn({
        moments: [across + top.arm ** 2, along, across + top.arm ** 2],
        orientation: top.lean,
        spin: spinning,
        arm: [0, top.arm, 0],
        weight: [0, -9.81, 0],
      });
      let worst = 0;
      for (let frame = 1; frame <= 180; frame++) {
        w.advance(1 / 60);
        const leans = rotate(truth(frame), [0, top.arm, 0]);
        worst = Math.max(worst, distance(position(disc), leans));
      }
      below(worst, tolerance, 'm');
    });
  }
});

describe('a slider-crank', () => {
  fact('x = r cos θ + √(l² - r² sin² θ)', async () => {
    const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
    const [r, l] = [0.3, 1];
    const crank = addBody(w, {
      geometry: [],
      mass: 50,
      inertia: moments(50),
      angularVelocity: [0, 0, 4],
    });
    const rod = addBody(w, {
      geometry: [],
      position: [r + l / 2, 0, 0],
      linearVelocity: [0, 0.6, 0],
      angularVelocity: [0, 0, -1.2],
      inertia: moments(0.1),
    });
    const piston = addBody(w, { geometry: [], position: [r + l, 0, 0], inertia: moments(0.1) });
    const crankHinge = w.add('SingleAxisHingeJoint', { body1: crank, axis: [0, 0, 1] });
    const pins = [
      w.add('SingleAxisHingeJoint', {
        body1: crank,
        body2: rod,
        axis: [0, 0, 1],
        anchorPoint: [r, 0, 0],
      }),
      w.add('BallJoint', { body1: rod, body2: piston, anchorPoint: [r + l, 0, 0] }),
    ];
    const slider = w.add('SliderJoint', {
      body1: piston,
      axis: [1, 0, 0],
      minSeparation: 1,
      maxSeparation: 0,
    });
    let [worst, gap] = [0, 0];
    for (let i = 0; i < 960; i++) {
      w.step();
      const theta = output(crankHinge, 'angle');
      const x = r * Math.cos(theta) + Math.sqrt(l * l - (r * Math.sin(theta)) ** 2);
      worst = Math.max(
        worst,
        Math.abs(position(piston)[0] - x),
        Math.abs(output(slider, 'separation') - (x - r - l)),
      );
      gap = Math.max(gap, ...pins.map(gapOf));
    }
    close(worst, 0, 1.4e-4, 'm');
    below(gap, 1.2e-4, 'm, gap');
  });
});
