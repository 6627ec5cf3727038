import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  velocity,
  world,
  type Body,
  type Hinge,
  type Joint,
  type Vec3,
} from '../../../../core/helpers.js';

const widest = (joints: readonly Joint[]): number => Math.max(...joints.map((joint) => joint.gap));
const fastest = (bodies: readonly Body[]): number =>
  Math.max(...bodies.map((body) => Math.hypot(...velocity(body))));

/** Trunk, head, arms and legs of two parts each: hinges with stops at elbows and knees, ball joints elsewhere. */
function addRagdoll(w: World, at: number): { bodies: Body[]; joints: Joint[]; hinges: Hinge[] } {
  const part = (x: number, y: number, size: Vec3): Body =>
    addBody(w, {
      position: [x, at + y, 0],
      geometry: [box(...size)],
      mass: 1000 * size[0] * size[1] * size[2],
    });
  const trunk = part(0, 0, [0.4, 0.6, 0.2]);
  const head = part(0, 0.45, [0.2, 0.26, 0.2]);
  const bodies = [trunk, head];
  const joints = [
    addJoint(w, 'BallJoint', { body1: head, body2: trunk, anchorPoint: [0, at + 0.31, 0] }),
  ];
  const hinges: Hinge[] = [];
  const limb = (x: number, top: number, long: number, thick: number): void => {
    const upper = part(x, top - long / 2, [thick, long - 0.02, thick]);
    const lower = part(x, top - 1.5 * long, [thick, long - 0.02, thick]);
    const bend = { axis: [1, 0, 0], minAngle: -2, maxAngle: 0.1 };
    joints.push(
      addJoint(w, 'BallJoint', { body1: upper, body2: trunk, anchorPoint: [x, at + top, 0] }),
    );
    const anchorPoint = [x, at + top - long, 0];
    hinges.push(
      addJoint(w, 'SingleAxisHingeJoint', { body1: lower, body2: upper, anchorPoint, ...bend }),
    );
    bodies.push(upper, lower);
  };
  for (const side of [-1, 1]) {
    limb(0.27 * side, 0.28, 0.3, 0.1);
    limb(0.12 * side, -0.31, 0.42, 0.14);
  }
  return { bodies, joints: [...joints, ...hinges], hinges };
}

for (const accuracy of ['game', 'standard'] as const) {
  fact(`a ragdoll dropped on a stair stays whole and comes to rest at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addFloor(w);
    for (let i = 0; i < 5; i++)
      addBody(w, {
        fixed: true,
        position: [0, 0.5 - 0.1 * i, -0.5 + 0.3 * i],
        geometry: [box(4, 1 - 0.2 * i, 0.3)],
      });
    const { bodies, joints, hinges } = addRagdoll(w, 3);
    let [gap, speed, past] = [0, 0, 0];
    for (let i = 0; i < 10 / w.timeStep; i++) {
      w.step();
      gap = Math.max(gap, widest(joints));
      speed = Math.max(speed, fastest(bodies));
      for (const { angle } of hinges) past = Math.max(past, angle - 0.1, -2 - angle);
    }
    assert.ok(bodies.every((body) => position(body).every(Number.isFinite)));
    below(gap, 1e-3, 'm');
    below(past, 0.01, 'rad past a stop');
    // Fallen from 4 m it comes with 9 m/s; a limb may whip.
    below(speed, 20, 'm/s');
    below(fastest(bodies), 0.1, 'm/s at the end');
    below(height(bodies[0]!), 1.7, 'm, it lies');
  });
}

fact('a motor driven into its stop stands there, and the bodies do not part', async () => {
  const w = await world({ accuracy: 'standard' });
  const arm = addBody(w, { position: [0.5, 0, 0], geometry: [box(1, 0.1, 0.1)] });
  const joint = addJoint(w, 'SingleAxisHingeJoint', {
    body1: arm,
    axis: [0, 0, 1],
    minAngle: -0.5,
    maxAngle: 0.5,
  });
  w.add('MotorJoint', { body1: arm, motor1Axis: [0, 0, 1], axis1Torque: 60 });
  let [gap, most] = [0, -Infinity];
  for (let i = 0; i < 5 / w.timeStep; i++) {
    w.step();
    gap = Math.max(gap, joint.gap);
    most = Math.max(most, joint.angle);
  }
  below(gap, 1e-4, 'm');
  below(most, 0.51, 'rad');
  close(joint.angle, 0.5, 0.01, 'rad');
  below(Math.abs(spin(arm)[2]), 0.01, 'rad/s');
});

fact('a wheel on a suspension rolls over a bump: its joint holds all but the spring', async () => {
  const w = await world({ accuracy: 'standard' });
  addFloor(w, 0, { geometry: [box(60, 1, 60)] });
  addBody(w, { fixed: true, position: [3, 0, 0], geometry: [box(0.4, 0.1, 4)] });
  const car = addBody(w, { position: [0, 0.8, 0], mass: 100, geometry: [box(1.6, 0.2, 0.8)] });
  const joints: Joint[] = [];
  const wheels: Body[] = [];
  for (const x of [-0.7, 0.7])
    for (const z of [-0.6, 0.6]) {
      const wheel = addBody(w, { position: [x, 0.35, z], mass: 5, geometry: [sphere(0.35)] });
      wheels.push(wheel);
      joints.push(
        addJoint(w, 'DoubleAxisHingeJoint', {
          body1: car,
          body2: wheel,
          anchorPoint: [x, 0.35, z],
          axis1: [0, 1, 0],
          axis2: [0, 0, 1],
          minAngle1: 0,
          maxAngle1: 0,
          suspensionForce: 2e-3,
          suspensionErrorCorrection: 0.5,
        }),
      );
    }
  w.advance(1);
  for (const body of [car, ...wheels]) body.event('linearVelocity', [4, 0, 0]);
  for (const wheel of wheels) wheel.event('angularVelocity', [0, 0, -4 / 0.35]);
  const rest = height(car);
  let [aside, travel, lifted] = [0, 0, 0];
  for (let i = 0; i < 3 / w.timeStep; i++) {
    w.step();
    lifted = Math.max(lifted, ...wheels.map((wheel) => height(wheel) - 0.35));
    for (const joint of joints) {
      const apart = joint.anchorOn(1).map((x, k) => x - joint.anchorOn(2)[k]!);
      // Along the car's own upright the spring gives way.
      const up = joint.axisOn(1, 2);
      const along = apart.reduce((sum, x, k) => sum + x * up[k]!, 0);
      travel = Math.max(travel, Math.abs(along));
      aside = Math.max(aside, Math.sqrt(Math.max(0, Math.hypot(...apart) ** 2 - along ** 2)));
    }
  }
  above(lifted, 0.03, 'm, the bump lifts a wheel');
  below(aside, 1e-3, 'm aside');
  below(travel, 0.2, 'm of the spring');
  close(height(car), rest, 0.02, 'm, the car rides as before');
  above(position(car)[0], 5, 'm, past the bump');
});
