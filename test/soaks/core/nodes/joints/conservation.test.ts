import { describe } from 'node:test';
import type { World } from '../../../../../physics-core/inside.js';
import type { JointNode } from '../../../../../physics-core/nodes/joints/joint.js';
import {
  add,
  cross,
  dot,
  normalize,
  quaternionOf,
  rotate,
  scale,
  subtract,
} from '../../../../../physics-core/base/math.js';
import {
  addBody,
  below,
  box,
  close,
  distance,
  fact,
  position,
  spin,
  velocity,
  world,
  type Body,
  type Node,
  type Vec3,
  WEIGHTLESS,
} from '../../../../core/helpers.js';

const output = (joint: Node, name: string): number => joint.get(name) as number;
const gapOf = (joint: Node): number => (joint as JointNode).gap;

// ---- what two free bodies keep ---------------------------------------------------------------------------------------

const center = (body: Body): Vec3 => body.centerOfMassWorld();
const centerVelocity = (body: Body): Vec3 =>
  add(velocity(body), cross(spin(body), subtract(center(body), position(body))));

/** I ω in the world. */
function angularMomentum(body: Body): Vec3 {
  const q = quaternionOf(body.get('orientation') as number[]);
  const axes = body.centerOfMass.q;
  const turn = (v: Vec3): Vec3 => rotate(q, rotate(axes, v));
  const back = (v: Vec3): Vec3 =>
    [0, 1, 2].map((i) => dot(v, turn([+(i === 0), +(i === 1), +(i === 2)]))) as Vec3;
  const local = back(spin(body)).map((w, i) => w * body.mass.moments[i]!) as Vec3;
  return turn(local);
}

function momenta(bodies: Body[]): { linear: Vec3; angular: Vec3; energy: number } {
  let [linear, angular, energy]: [Vec3, Vec3, number] = [[0, 0, 0], [0, 0, 0], 0];
  for (const body of bodies) {
    const v = centerVelocity(body);
    const own = angularMomentum(body);
    linear = add(linear, scale(v, body.mass.mass));
    angular = add(angular, add(own, cross(center(body), scale(v, body.mass.mass))));
    energy += (body.mass.mass * dot(v, v) + dot(spin(body), own)) / 2;
  }
  return { linear, angular, energy };
}

const moments = (m: number): number[] => [m, 0, 0, 0, m, 0, 0, 0, m];

/** Two boxes of 2 and 3 kg with their masses off their centres, turned any which way, moving as the joint allows. */
async function tumbling(
  type: string,
  fields: Record<string, unknown> = {},
  round = false,
): Promise<{ w: World; a: Body; b: Body; joint: Node }> {
  const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
  const a = addBody(w, {
    mass: 2,
    geometry: [box(1, 0.6, 0.4)],
    centerOfMass: [0.1, -0.05, 0.05],
    ...(round && { inertia: moments(0.2) }),
    position: [-0.8, 0.2, 0],
    orientation: [0.6, 0, 0.8, 0.7],
  });
  const b = addBody(w, {
    mass: 3,
    geometry: [box(0.5, 0.8, 0.6)],
    centerOfMass: [-0.05, 0.1, 0],
    ...(round && { inertia: moments(0.3) }),
    position: [0.7, 0, 0.3],
    orientation: [0, 0.6, 0.8, -1.1],
  });
  const joint = w.add(type, { body1: a, body2: b, ...JOINTS[type], ...fields });
  w.step();
  a.applyImpulse([1, 2, -1], [-0.5, 0.3, 0.1]);
  b.applyImpulse([-1, 0.5, 1.5], [0.8, 0.2, 0.2]);
  // The joint takes out of the blow what it does not allow.
  w.step(8);
  return { w, a, b, joint };
}

const SLANT = normalize([1, 2, 2]);
const ACROSS = normalize([2, 1, -2]);
const JOINTS: Record<string, Record<string, unknown>> = {
  BallJoint: { anchorPoint: [0, 0.1, 0.1] },
  SingleAxisHingeJoint: { anchorPoint: [0, 0.1, 0.1], axis: SLANT },
  DoubleAxisHingeJoint: { anchorPoint: [0, 0.1, 0.1], axis1: SLANT, axis2: ACROSS },
  UniversalJoint: { anchorPoint: [0, 0.1, 0.1], axis1: SLANT, axis2: ACROSS },
  SliderJoint: { axis: SLANT, minSeparation: 1, maxSeparation: 0 },
  MotorJoint: {
    enabledAxes: 3,
    axis1Torque: 0.1,
    axis2Torque: -0.2,
    axis3Torque: 0.3,
    motor1Axis: SLANT,
  },
};

/** Axes that are not at right angles, and angles that are measured. */
const SLANTING = { axis2: normalize([1, 3, 0]) };
const EULER = { autoCalc: true, motor3Axis: ACROSS };

describe('two free bodies with their masses off centre, turned any which way', () => {
  for (const type of Object.keys(JOINTS)) {
    fact(`${type}: keeps momentum and energy, and does not gape`, async () => {
      const { w, a, b, joint } = await tumbling(type);
      const before = momenta([a, b]);
      let gap = 0;
      for (let i = 0; i < 480; i++) {
        w.step();
        if (joint.type.fields['anchorPoint']) gap = Math.max(gap, gapOf(joint));
      }
      const after = momenta([a, b]);
      // Momenta of 5 kg m/s in single precision. Energy and angular momentum: second order in the step where a joint
      // pulls while its bodies tumble (measured, × 2).
      close(after.linear, before.linear, 6e-6, 'kg m/s');
      if (type !== 'MotorJoint') close(after.energy / before.energy, 1, 2.3e-4, 'of the energy');
      const lost = distance(after.angular, before.angular) / Math.hypot(...before.angular);
      below(lost, 2e-3, 'of the angular momentum');
      below(gap, 2e-6, 'm, gap');
    });

    fact(
      `${type}: what it does to one body it undoes at the other: round bodies keep their angular momentum`,
      async () => {
        const { w, a, b } = await tumbling(type, {}, true);
        const before = momenta([a, b]).angular;
        w.step(480);
        const lost = distance(momenta([a, b]).angular, before) / Math.hypot(...before);
        below(lost, 8e-6, 'of the angular momentum');
      },
    );

    fact(`${type}: a force on one body moves both: F t is their momentum`, async () => {
      const { w, a, b, joint } = await tumbling(type);
      const before = momenta([a, b]).linear;
      a.set('forces', [[3, -2, 1]]);
      w.step(240);
      const gained = subtract(momenta([a, b]).linear, before);
      close(gained, [3, -2, 1], 3e-5, 'kg m/s after 1 s');
      if (joint.type.fields['anchorPoint']) below(gapOf(joint), 8e-5, 'm, gap');
    });
  }

  for (const [type, names, fields, tolerance] of [
    // The tolerance: what a step's change of the rate leaves over in half a second (measured, × 2).
    ['SingleAxisHingeJoint', ['angle'], {}, 1.4e-5],
    ['DoubleAxisHingeJoint', ['hinge1Angle', 'hinge2Angle'], {}, 4e-4],
    ['DoubleAxisHingeJoint', ['hinge1Angle', 'hinge2Angle'], SLANTING, 5e-4],
    ['SliderJoint', ['separation'], {}, 1e-3],
    ['MotorJoint', ['motor1Angle', 'motor2Angle', 'motor3Angle'], EULER, 1.3e-2],
  ] as const) {
    fact(
      `${type}: ${names.join(', ')} grow by their rates, ${Object.keys(fields).join(', ')}`,
      async () => {
        const { w, joint } = await tumbling(type, fields);
        const sums = names.map((name) => output(joint, name));
        const rates = (): number[] => names.map((name) => output(joint, `${name}Rate`));
        let before = rates();
        for (let i = 0; i < 120; i++) {
          w.step();
          const after = rates();
          after.forEach((rate, n) => (sums[n]! += ((before[n]! + rate) / 2) * w.timeStep));
          before = after;
        }
        names.forEach((name, n) => close(output(joint, name), sums[n]!, tolerance, name));
      },
    );
  }
});
