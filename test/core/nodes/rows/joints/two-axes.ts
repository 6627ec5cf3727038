import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../../physics-core/create.js';
import type { DoubleAxisHingeJointNode } from '../../../../../physics-core/nodes/joints/double-axis-hinge-joint-node.js';
import {
  addBody,
  below,
  claim,
  close,
  height,
  position,
  spin,
  world,
  WEIGHTLESS,
} from '../../../helpers.js';
import { bodies, heard } from './shared.js';
import type { Row } from '../row.js';

const parallel = (type: string): Row => ({
  field: 'axis2',
  fact: 'along axis1 is no axis: one at right angles is used, and its author is told',
  run: async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'bad-value');
    const [pin, ball] = [addBody(w, { fixed: true }), addBody(w)];
    const joint = w.add(type, { body1: pin, body2: ball, axis1: [0, 1, 0], axis2: [0, 2, 0] });
    w.step();
    assert.equal(w.problems[0]!.attribute, 'axis2');
    ball.event('angularVelocity', [0, 1, 0]);
    w.step();
    close(spin(ball), [0, 1, 0], 1e-4, 'rad/s, about axis1');
    joint.set('axis2', [1, 0, 0]);
    w.step();
    assert.deepEqual(w.problems, []);
  },
});

const noDirection = (type: string, field: 'axis1' | 'axis2'): Row => ({
  field,
  fact: 'without a direction the default is used, and its author is told',
  run: async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'bad-value');
    const [pin, ball] = [addBody(w, { fixed: true }), addBody(w)];
    const joint = w.add(type, { body1: pin, body2: ball, [field]: [0, 0, 0] });
    w.step();
    assert.deepEqual(w.problems[0]!.used, field === 'axis1' ? [1, 0, 0] : [0, 1, 0]);
    ball.event('angularVelocity', [1, 1, 1]);
    w.step();
    close(spin(ball), [1, 1, 0], 2e-2, 'rad/s');
    joint.remove();
  },
});

export const universalRows: Row[] = [
  ...bodies('UniversalJoint'),
  parallel('UniversalJoint'),
  noDirection('UniversalJoint', 'axis1'),
  noDirection('UniversalJoint', 'axis2'),
  {
    field: 'axis2',
    fact: 'not at right angles to axis1 is turned until it is, and its author is told',
    run: async () => {
      const w = await world(WEIGHTLESS);
      claim(w, 'bad-value');
      const [pin, ball] = [addBody(w, { fixed: true }), addBody(w)];
      const joint = w.add('UniversalJoint', { body1: pin, body2: ball, axis2: [3, 4, 0] });
      w.step();
      close(joint.get('body2Axis') as number[], [0, 1, 0], 1e-6);
      ball.event('angularVelocity', [0, 1, 1]);
      w.step();
      close(spin(ball), [0, 1, 0], 1e-2, 'rad/s');
    },
  },
];

/** A wheel of 1 kg and 0.1 kg·m² under the world; it is body2, so its turns count backwards. */
async function wheel(fields: Record<string, unknown> = {}, settings: CreateOptions = WEIGHTLESS) {
  const w = await world(settings);
  const pin = addBody(w, { fixed: true });
  const ball = addBody(w);
  const hinge = w.add('DoubleAxisHingeJoint', {
    body1: pin,
    body2: ball,
    axis1: [0, 1, 0],
    axis2: [1, 0, 0],
    ...fields,
  }) as DoubleAxisHingeJointNode;
  w.step();
  return { w, pin, ball, hinge };
}

const wakes = (field: string, value: number): Row => ({
  field,
  fact: `an edit of ${field} wakes a sleeping wheel`,
  run: async () => {
    const { w, ball, hinge } = await wheel({ suspensionForce: 0.1 });
    ball.sleep();
    w.step();
    assert.equal(ball.sleeping, true);
    hinge.set(field, value);
    w.step();
    assert.equal(ball.sleeping, false);
  },
});

export const doubleHingeRows: Row[] = [
  ...bodies('DoubleAxisHingeJoint'),
  parallel('DoubleAxisHingeJoint'),
  noDirection('DoubleAxisHingeJoint', 'axis1'),
  noDirection('DoubleAxisHingeJoint', 'axis2'),
  {
    field: 'axis2',
    fact: 'may slant towards axis1: the angle between them stays, and the wheel spins about it',
    run: async () => {
      const { w, ball, hinge } = await wheel({ axis2: [0.8, 0.6, 0], minAngle1: 0, maxAngle1: 0 });
      ball.event('angularVelocity', [4, 3, 1]);
      w.advance(0.5);
      const about = spin(ball)[0] * 0.8 + spin(ball)[1] * 0.6;
      close(about, 5, 0.01, 'rad/s');
      close(hinge.get('hinge2Angle') as number, -2.5, 0.05, 'rad');
      close(hinge.get('hinge1Angle') as number, 0, 1e-3, 'rad');
      const [a, b] = [hinge.get('body1Axis'), hinge.get('body2Axis')] as [number[], number[]];
      close(a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!, 0.6, 1e-4, 'cosine between them');
    },
  },
  {
    field: 'minAngle1',
    fact: 'equal to maxAngle1 it holds the wheel there, against any torque',
    run: async () => {
      const { w, ball, hinge } = await wheel({ stop1ConstantForceMix: 0 });
      hinge.set('minAngle1', -0.3);
      hinge.set('maxAngle1', -0.3);
      w.advance(0.5);
      close(hinge.hingeAngle(1), -0.3, 1e-4, 'rad');
      ball.set('torques', [[0, 50, 0]]);
      w.advance(0.5);
      close(hinge.hingeAngle(1), -0.3, 1e-4, 'rad, pushed');
      hinge.set('minAngle1', 1);
      w.advance(0.1);
      below(hinge.hingeAngle(1), -1, 'rad, min above max');
    },
  },
  {
    field: 'maxAngle1',
    effect: 'stops',
    fact: 'a motor that presses into the stop stays within 0.01 rad of it',
    run: async () => {
      const { w, hinge } = await wheel({
        maxAngle1: 0.5,
        desiredAngularVelocity1: 5,
        maxTorque1: 10,
      });
      for (let i = 0; i < 240; i++) {
        w.step();
        below(hinge.hingeAngle(1), 0.51, 'rad');
      }
      close(hinge.hingeAngle(1), 0.5 + (10 * 0.001) / (60 * 0.8), 1e-4, 'rad, soft as it is');
    },
  },
  {
    field: 'maxAngle1',
    effect: 'stops',
    fact: 'the stop is told once, with its axis',
    run: async () => {
      const { w, ball, hinge } = await wheel({ minAngle1: -0.2, maxAngle1: 0.2 });
      const limits = heard(hinge);
      ball.event('angularVelocity', [0, 1, 0]);
      w.advance(1);
      assert.deepEqual(limits, [{ limit: 'min', value: -0.2, axis: 1 }]);
    },
  },
  ...[
    ['stopBounce1', 'stop1Bounce', 0.5],
    ['stopErrorCorrection1', 'stop1ErrorCorrection', 0.3],
    ['stopConstantForceMix1', 'stop1ConstantForceMix', 0.02],
  ].map(([old, field, value]): Row => ({
    field: field as string,
    fact: `is what X3D 3.x calls ${old}`,
    run: async () => {
      const { hinge } = await wheel();
      const before = hinge.get(field as string);
      hinge.set(old as string, value);
      assert.deepEqual([hinge.get(field as string), hinge.get(old as string)], [value, value]);
      hinge.event(old as string, 0.1);
      assert.equal(hinge.get(field as string), 0.1);
      hinge.unset(old as string);
      assert.equal(hinge.get(field as string), before);
    },
  })),
  ...([1, 2] as const).map((n): Row => ({
    field: `maxTorque${n}`,
    effect: 'motors',
    fact: 'the motor keeps its rate under a load it can bear, and the effect ends with it',
    run: async () => {
      const { w, ball, hinge } = await wheel({
        [`desiredAngularVelocity${n}`]: -3,
        [`maxTorque${n}`]: 5,
      });
      ball.set('torques', [n === 1 ? [0, -4, 0] : [-4, 0, 0]]);
      w.advance(1);
      close(hinge.hingeAngleRate(n), -3, 1e-3, 'rad/s');
      const active = () => w.effects.find(({ name }) => name === 'motors')!.active;
      assert.equal(active(), true);
      hinge.unset(`maxTorque${n}`);
      w.step();
      assert.equal(active(), false);
    },
  })),
  {
    field: 'suspensionForce',
    effect: 'suspension',
    fact: 'sinks in alike at every level, soft or stiff, and off its centre too',
    run: async () => {
      for (const accuracy of ['game', 'standard', 'fine'] as const)
        for (const force of [0.1, 0.002, 0.0002]) {
          const { w, ball } = await wheel(
            { suspensionForce: force, suspensionErrorCorrection: 0.5 },
            { accuracy, gravity: [0, -10, 0] },
          );
          w.advance(4);
          const sag = (10 * force) / (60 * 0.5);
          close(height(ball), -sag, 0.01 * sag + 1e-6, `m at ${force}, ${accuracy}`);
        }
    },
  },
  {
    field: 'suspensionForce',
    effect: 'suspension',
    fact: 'bears a car whose wheels stand on the ground: it sinks by its weight over the stiffness',
    run: async () => {
      const w = await world({ gravity: [0, -10, 0] });
      const wheelBody = addBody(w, { fixed: true, mass: 20 });
      const car = addBody(w, { mass: 200, position: [0, 1, 0] });
      const strut = w.add('DoubleAxisHingeJoint', {
        body1: car,
        body2: wheelBody,
        axis1: [0, 1, 0],
        axis2: [1, 0, 0],
        minAngle1: 0,
        maxAngle1: 0,
        suspensionForce: 0.002,
        suspensionErrorCorrection: 0.4,
      });
      w.advance(6);
      close(position(car)[1], 1 - (2000 * 0.002) / (60 * 0.4), 2e-3, 'm');
      strut.remove();
      assert.equal(w.effects.find(({ name }) => name === 'suspension')!.active, false);
    },
  },
  wakes('suspensionForce', 0.2),
  wakes('suspensionErrorCorrection', 0.5),
  wakes('stop1Bounce', 0.5),
  wakes('stop1ErrorCorrection', 0.5),
  wakes('maxTorque1', 1),
  wakes('desiredAngularVelocity2', 1),
];
