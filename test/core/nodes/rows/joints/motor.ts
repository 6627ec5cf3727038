import assert from 'node:assert/strict';
import { quaternionOf, rotate } from '../../../../../physics-core/base/math.js';
import {
  above,
  addBody,
  addJoint,
  below,
  claim,
  close,
  codes,
  position,
  spin,
  world,
  WEIGHTLESS,
} from '../../../helpers.js';
import { forceOutput } from './shared.js';
import type { Row } from '../row.js';

/** Solid sphere of 1 kg and 0.5 m. */
const MOMENT = 0.1;

/** A weightless ball with a motor; `spinAfter` gives ω after a tenth of a second from rest. */
async function motor(fields: Record<string, unknown>) {
  const w = await world(WEIGHTLESS);
  const ball = addBody(w);
  const joint = w.add('MotorJoint', { body1: ball, ...fields });
  const spinAfter = () => {
    ball.event('orientation', [0, 0, 1, 0]);
    ball.event('angularVelocity', [0, 0, 0]);
    w.advance(0.1);
    return spin(ball);
  };
  return { w, ball, joint, spinAfter };
}

const unit = (n: number): number[] => [1, 2, 3].map((i) => (i === n ? 1 : 0));
const times = (vector: number[], factor: number): number[] => vector.map((value) => value * factor);
/** rad/s that 1 N·m gives in 0.1 s. */
const GAIN = 0.1 / MOMENT;

export const motorRows: Row[] = [
  ...(['body1', 'body2'] as const).map((field): Row => ({
    field,
    effect: 'motors',
    fact: `the torque acts on whom ${field} names now: plus on body1, minus on body2`,
    run: async () => {
      const w = await world(WEIGHTLESS);
      const [a, b, c] = [0, 2, 4].map((x) => addBody(w, { position: [x, 0, 0] }));
      const joint = w.add('MotorJoint', { body1: a, body2: b, axis1Torque: 1 });
      w.advance(0.1);
      close([spin(a!)[0], spin(b!)[0]], [GAIN, -GAIN], 1e-4, 'rad/s');
      joint.set(field, c);
      w.advance(0.1);
      const [old, kept] = field === 'body1' ? [a!, b!] : [b!, a!];
      const sign = field === 'body1' ? 1 : -1;
      close(spin(old)[0], sign * GAIN, 1e-4, 'rad/s, let go');
      close(spin(kept)[0], -2 * sign * GAIN, 1e-4, 'rad/s, kept');
      close(spin(c!)[0], sign * GAIN, 1e-4, 'rad/s, taken on');
    },
  })),
  {
    ...forceOutput('MotorJoint'),
  },
  {
    field: 'enabledAxes',
    fact: 'is how many axes are driven',
    run: async () => {
      const { w, joint, spinAfter } = await motor({
        enabledAxes: 1,
        axis1Torque: 1,
        axis2Torque: 2,
        axis3Torque: 3,
      });
      for (const [axes, expected] of [
        [1, [1, 0, 0]],
        [2, [1, 2, 0]],
        [3, [1, 2, 3]],
        [0, [0, 0, 0]],
      ] as const) {
        joint.set('enabledAxes', axes);
        // The axes turn with the body, by up to a tenth of a radian here.
        close(spinAfter(), times([...expected], GAIN), axes > 1 ? 0.4 : 1e-4, `rad/s at ${axes}`);
      }
      joint.unset('enabledAxes');
      close(spinAfter(), [GAIN, 0, 0], 1e-4, 'rad/s, unset');
      claim(w, 'idle-motor');
    },
  },
  {
    field: 'enabledAxes',
    fact: 'a motor without axes does nothing until it gets some',
    run: async () => {
      const { joint, spinAfter } = await motor({ enabledAxes: 0, axis1Torque: 1 });
      close(spinAfter(), [0, 0, 0], 0, 'rad/s at 0');
      joint.set('enabledAxes', 1);
      close(spinAfter(), [GAIN, 0, 0], 1e-4, 'rad/s at 1');
    },
  },
  {
    field: 'autoCalc',
    fact: 'switched on it measures the angles from the poses of that moment',
    run: async () => {
      const { w, ball, joint } = await motor({ axis1Angle: 0.3, enabledAxes: 3 });
      claim(w, 'idle-motor');
      w.step();
      ball.event('orientation', [0, 1, 0, 0.5]);
      w.step();
      close(joint.get('motor1Angle') as number, 0.3, 1e-6, 'rad, told');
      joint.set('autoCalc', true);
      const angles = [1, 2, 3].map((n) => joint.get(`motor${n}Angle`) as number);
      close(angles, [0, 0, 0], 1e-6, 'rad, from now on');
      ball.event('orientation', [1, 0, 0, 0.4]);
      joint.set('motor3Axis', [0, 1, 0]);
      close(joint.get('motor3Angle') as number, 0, 1e-6, 'rad, made anew');
      joint.unset('autoCalc');
      close(joint.get('motor1Angle') as number, 0.3, 1e-6, 'rad, told');
    },
  },
  ...[1, 2, 3].flatMap((n): Row[] => [
    {
      field: `axis${n}Angle`,
      fact: `an angle about axis ${n} without any torque is told when it is written, and no more when it goes`,
      run: async () => {
        const { w, joint } = await motor({});
        w.step();
        claim(w, 'idle-motor');
        joint.set(`axis${n}Angle`, 1);
        w.step(0);
        assert.deepEqual(codes(w), ['idle-motor']);
        joint.unset(`axis${n}Angle`);
        w.step(0);
        assert.deepEqual(codes(w), []);
      },
    },
    {
      field: `motor${n}Axis`,
      fact: `axis ${n} is a direction of the world when it is set, however the body stands then, and goes with it on`,
      run: async () => {
        const { w, ball, joint } = await motor({ enabledAxes: 3, [`axis${n}Torque`]: 1 });
        joint.set(`axis${n}Torque`, 0);
        w.step();
        ball.event('orientation', [0.6, 0, 0.8, 2]);
        w.step();
        joint.set(`motor${n}Axis`, [0, 3, 4]);
        w.step();
        ball.event('orientation', [0, 0, 1, 0]);
        joint.set(`axis${n}Torque`, 1);
        w.advance(0.1);
        // The axis as the body saw it: turned back about (0.6, 0, 0.8) by 2 rad.
        const seen = rotate(quaternionOf([0.6, 0, 0.8, -2]), [0, 0.6, 0.8]);
        close(spin(ball), times(seen, GAIN), 1e-4, 'rad/s');
      },
    },
    {
      field: `motor${n}Axis`,
      effect: 'motors',
      fact: `axis ${n} drives about its new direction, scaled to length 1`,
      run: async () => {
        const { ball, joint, spinAfter } = await motor({ enabledAxes: 3, [`axis${n}Torque`]: 1 });
        close(spinAfter(), times(unit(n), GAIN), 1e-4, 'rad/s about the default');
        ball.event('orientation', [0, 0, 1, 0]);
        joint.set(`motor${n}Axis`, [0, 3, 4]);
        close(spinAfter(), [0, 0.6 * GAIN, 0.8 * GAIN], 1e-4, 'rad/s about the new axis');
        ball.event('orientation', [0, 0, 1, 0]);
        joint.unset(`motor${n}Axis`);
        close(spinAfter(), times(unit(n), GAIN), 1e-4, 'rad/s, unset');
      },
    },
    {
      field: `axis${n}Torque`,
      effect: 'motors',
      fact: `another torque about axis ${n} gives another dω/dt = τ/I`,
      run: async () => {
        const { joint, spinAfter } = await motor({ enabledAxes: 3 });
        close(spinAfter(), [0, 0, 0], 0, 'rad/s without torque');
        joint.set(`axis${n}Torque`, 0.5);
        close(spinAfter(), times(unit(n), 0.5 * GAIN), 1e-4, 'rad/s');
        joint.set(`axis${n}Torque`, -2);
        close(spinAfter(), times(unit(n), -2 * GAIN), 1e-4, 'rad/s the other way');
        joint.unset(`axis${n}Torque`);
        close(spinAfter(), [0, 0, 0], 0, 'rad/s, unset');
      },
    },
  ]),
  {
    field: 'axis1Torque',
    fact: 'drives a body that another joint holds, for as long as it turns',
    run: async () => {
      const w = await world();
      const ball = addBody(w);
      addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 1, 0] });
      const joint = w.add('MotorJoint', { body1: ball, motor1Axis: [0, 1, 0] });
      w.advance(0.5);
      joint.set('axis1Torque', 0.2);
      w.advance(1);
      close(spin(ball), [0, 2, 0], 5e-3, 'rad/s = τ t / I');
      close(position(ball), [0, 0, 0], 1e-3, 'm');
      below(Math.abs(spin(ball)[0]), 1e-2);
      above(spin(ball)[1], 1.9);
    },
  },
];
