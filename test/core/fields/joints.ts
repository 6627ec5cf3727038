import assert from 'node:assert/strict';
import type { World } from '../../../physics-core/index.js';
import {
  above,
  addBody,
  addJoint,
  below,
  claim,
  close,
  counts,
  distance,
  height,
  position,
  sphere,
  spin,
  velocity,
  way,
  world,
  type Body,
  type Hinge,
} from '../helpers.js';
import type { Row } from './rows.js';

const WEIGHTLESS = { gravity: [0, 0, 0] };

/** Solid sphere of 1 kg and 0.5 m. */
const MOMENT = 0.1;

const axisOf = (type: string, axis: number[]) => (type === 'SingleAxisHingeJoint' ? { axis } : {});

/** Two balls side by side on a joint that holds the first, and one of them is let go by naming the other. */
function bodies(type: string): Row[] {
  return (['body1', 'body2'] as const).map((field) => ({
    field,
    fact: `the joint holds whom ${field} names now, and lets go of whom it named before`,
    run: async () => {
      const w = await world();
      const pin = addBody(w, { fixed: true, position: [0, 5, 0], geometry: [] });
      const [first, second] = [addBody(w), addBody(w, { position: [4, 0, 0] })];
      const other = field === 'body1' ? 'body2' : 'body1';
      const joint = addJoint(w, type, { [field]: first, [other]: pin, anchorPoint: [0, 0, 0] });
      w.advance(0.5);
      close(height(first), 0, 1e-3, 'm, held');
      close(height(second), -way(9.8, 0.5), 1e-3, 'm, free');
      second.event('position', [4, 0, 0]);
      second.event('linearVelocity', [0, 0, 0]);
      const { created } = counts(w);
      joint.set('anchorPoint', [4, 0, 0]);
      joint.set(field, second);
      w.advance(0.5);
      close(height(first), -way(9.8, 0.5), 1e-3, 'm, let go');
      close(height(second), 0, 1e-3, 'm, held instead');
      assert.equal(counts(w).created, created);
      // The other side becomes the world.
      joint.set(other, null);
      w.advance(0.5);
      close(height(second), 0, 1e-3, 'm, held by the world');
      claim(w, 'no-body');
      joint.set(field, null);
      w.advance(0.5);
      close(height(second), -way(9.8, 0.5), 2e-3, 'm, held by nobody');
    },
  }));
}

function forceOutput(type: string): Row {
  return {
    field: 'forceOutput',
    fact: 'says which outputs are sent; motion and objects stay as they are',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const ball = addBody(w, { angularVelocity: [0, 1, 0] });
      const joint = addJoint(w, type, { body1: ball, ...axisOf(type, [0, 1, 0]) });
      w.advance(0.5);
      const before = counts(w);
      joint.set('forceOutput', ['angle']);
      w.advance(0.5);
      close(ball.get('orientation') as number[], [0, 1, 0, 1], 1e-3, 'rad');
      assert.deepEqual({ ...counts(w), patched: 0 }, { ...before, patched: 0 });
      assert.deepEqual([joint.outputs('angle'), joint.outputs('angleRate')], [true, false]);
      joint.set('forceOutput', 'ALL');
      assert.equal(joint.outputs('angleRate'), true);
    },
  };
}

function outputAnchors(type: string): Row[] {
  return ([1, 2] as const).map((which) => ({
    field: `body${which}AnchorPoint`,
    fact: `is the anchor as body${which} carries it, also where the joint is torn open`,
    run: async () => {
      const w = await world(WEIGHTLESS);
      const [a, b] = [addBody(w), addBody(w, { position: [2, 0, 0] })];
      const joint = addJoint(w, type, { body1: a, body2: b, anchorPoint: [1, 0, 0] });
      const anchor = () => joint.get(`body${which}AnchorPoint`) as number[];
      w.step();
      close(anchor(), [1, 0, 0], 1e-4, 'm');
      const moved = which === 1 ? a : b;
      moved.set('position', [0, 3, 0]);
      moved.set('orientation', [0, 0, 1, Math.PI / 2]);
      // The anchor lies a metre along the body's x, forward or back, which now points up.
      close(anchor(), [0, which === 1 ? 4 : 2, 0], 1e-4, 'm, carried by the body');
      moved.event('position', [which === 1 ? 0 : 2, 0, 0]);
      moved.event('orientation', [0, 0, 1, 0]);
      a.set('linearVelocity', [0, 1, 0]);
      b.set('linearVelocity', [0, 1, 0]);
      w.advance(1);
      close(anchor(), [1, 1, 0], 1e-3, 'm, carried along');
    },
  }));
}

function anchorPoint(type: string): Row {
  return {
    field: 'anchorPoint',
    fact: 'a hanging ball swings about its new anchor: distance kept, ½ v² = g h',
    run: async () => {
      const w = await world({ accuracy: 'fine' });
      const ball = addBody(w, { geometry: [sphere(0.05)] });
      const joint = addJoint(w, type, {
        body1: ball,
        anchorPoint: [0, 1, 0],
        ...axisOf(type, [0, 0, 1]),
      });
      w.advance(0.5);
      close(position(ball), [0, 0, 0], 1e-3, 'm, hanging');
      joint.set('anchorPoint', [1, 0, 0]);
      let fastest = 0;
      for (let i = 0; i < 240; i++) {
        w.step();
        close(distance(position(ball), [1, 0, 0]), 1, 5e-3, 'm from the anchor');
        fastest = Math.max(fastest, Math.hypot(...velocity(ball)));
      }
      // From the level of the anchor through the lowest point; 1 + 2/5 r² of its moment turns along.
      close(fastest, Math.sqrt((2 * 9.8) / (1 + 0.4 * 0.0025)), 0.05, 'm/s');
    },
  };
}

export const ballRows: Row[] = [
  ...bodies('BallJoint'),
  forceOutput('BallJoint'),
  anchorPoint('BallJoint'),
  ...outputAnchors('BallJoint'),
];

/** A ball that turns about Z through its centre on a hinge held by the world. */
async function wheel(fields: Record<string, unknown> = {}, body: Record<string, unknown> = {}) {
  const w = await world({ ...WEIGHTLESS, accuracy: 'fine' });
  const ball = addBody(w, body);
  const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 1], ...fields });
  w.step();
  return { w, ball, hinge };
}

/** Largest angle that a wheel set turning comes to in a second. */
function reaches(w: World, ball: Body, hinge: Hinge, rate: number): number {
  ball.event('orientation', [0, 0, 1, 0]);
  ball.event('angularVelocity', [0, 0, rate]);
  let most = 0;
  for (let i = 0; i < 240; i++) {
    w.step();
    if (Math.abs(hinge.angle) > Math.abs(most)) most = hinge.angle;
  }
  return most;
}

/** What is left of 0.1 rad beyond a stop after one step of 1/60 s. */
async function overshootLeft(correction: number | undefined): Promise<number> {
  const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
  const ball = addBody(w);
  const hinge = addJoint(w, 'SingleAxisHingeJoint', {
    body1: ball,
    axis: [0, 0, 1],
    maxAngle: 0.5,
    stopErrorCorrection: 0.3,
  });
  w.step();
  if (correction === undefined) hinge.unset('stopErrorCorrection');
  else hinge.set('stopErrorCorrection', correction);
  ball.set('orientation', [0, 0, 1, 0.6]);
  w.step();
  return hinge.angle - 0.5;
}

export const hingeRows: Row[] = [
  ...bodies('SingleAxisHingeJoint'),
  forceOutput('SingleAxisHingeJoint'),
  anchorPoint('SingleAxisHingeJoint'),
  ...outputAnchors('SingleAxisHingeJoint'),
  {
    field: 'axis',
    fact: 'a body turns freely about the new axis and about no other',
    run: async () => {
      const { w, ball, hinge } = await wheel();
      ball.event('angularVelocity', [1, 2, 3]);
      w.advance(0.2);
      close(spin(ball), [0, 0, 3], 2e-3, 'rad/s about Z');
      hinge.set('axis', [0, 5, 0]);
      ball.event('angularVelocity', [1, 2, 3]);
      w.advance(0.2);
      close(spin(ball), [0, 2, 0], 2e-3, 'rad/s about Y');
      hinge.unset('axis');
      ball.event('angularVelocity', [1, 2, 3]);
      w.advance(0.2);
      close(spin(ball), [0, 2, 0], 2e-3, 'rad/s about the default, Y');
    },
  },
  {
    field: 'minAngle',
    fact: 'a wheel turning backwards stops at the new lower stop',
    run: async () => {
      const { w, ball, hinge } = await wheel();
      close(reaches(w, ball, hinge, -1), -1, 5e-3, 'rad, no stops');
      hinge.set('minAngle', -0.4);
      close(reaches(w, ball, hinge, -1), -0.4, 1e-3, 'rad, stopped');
      hinge.set('maxAngle', -0.6);
      close(reaches(w, ball, hinge, -1), -1, 5e-3, 'rad, min above max: no stops');
    },
  },
  {
    field: 'maxAngle',
    effect: 'stops',
    fact: 'a wheel stops at the new upper stop and does not spring back',
    run: async () => {
      const { w, ball, hinge } = await wheel();
      close(reaches(w, ball, hinge, 1), 1, 5e-3, 'rad, no stops');
      hinge.set('maxAngle', 0.6);
      close(reaches(w, ball, hinge, 1), 0.6, 1e-3, 'rad, stopped');
      close(hinge.angle, 0.6, 1e-3, 'rad, still there');
      hinge.unset('maxAngle');
      close(reaches(w, ball, hinge, 1), 1, 5e-3, 'rad, unset');
    },
  },
  {
    field: 'stopBounce',
    effect: 'stops',
    fact: 'a wheel leaves the stop with this share of its rate, off its centre too',
    run: async () => {
      for (const at of [
        [0, 0, 0],
        [1, 0, 0],
      ]) {
        const { w, ball, hinge } = await wheel({ maxAngle: 0.3 }, { position: at });
        for (const bounce of [0.5, 1]) {
          hinge.set('stopBounce', bounce);
          ball.event('orientation', [0, 0, 1, 0]);
          ball.event('position', at);
          ball.event('linearVelocity', [0, at[0]!, 0]);
          ball.event('angularVelocity', [0, 0, 1]);
          w.advance(0.5);
          close(hinge.angleRate, -bounce, 5e-3, `rad/s at ${bounce}`);
        }
        hinge.unset('stopBounce');
        reaches(w, ball, hinge, 0);
        ball.event('position', at);
        ball.event('linearVelocity', [0, at[0]!, 0]);
        ball.event('angularVelocity', [0, 0, 1]);
        w.advance(0.5);
        close(hinge.angleRate, 0, 5e-3, 'rad/s, unset');
      }
    },
  },
  ...['stopBounce', 'minAngle', 'stopErrorCorrection'].map((field): Row => ({
    field,
    fact: `an edit of ${field} wakes a sleeping wheel`,
    run: async () => {
      const { w, ball, hinge } = await wheel({ maxAngle: 1 });
      w.advance(0.1);
      ball.sleep();
      w.step();
      assert.equal(ball.body.isActive(), false);
      hinge.set(field, 0.1);
      w.step();
      assert.equal(ball.body.isActive(), true);
    },
  })),
  {
    field: 'stopErrorCorrection',
    fact: 'the share of an overshoot that one step of 1/60 s repairs',
    run: async () => {
      close(await overshootLeft(0.2), 0.08, 2e-3, 'rad left at 0.2');
      close(await overshootLeft(0.5), 0.05, 2e-3, 'rad left at 0.5');
      close(await overshootLeft(undefined), 0.02, 2e-3, 'rad left at the default of 0.8');
    },
  },
  {
    field: 'angle',
    fact: 'is the turn of body1 against body2 since the joint was made, in (-π, π]',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const [a, b] = [addBody(w), addBody(w)];
      const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: a, body2: b, axis: [0, 0, 1] });
      w.step();
      a.set('orientation', [0, 0, 1, 0.5]);
      close(hinge.get('angle') as number, 0.5, 1e-5, 'rad');
      b.set('orientation', [0, 0, 1, 0.7]);
      close(hinge.get('angle') as number, -0.2, 1e-5, 'rad, body2 turned more');
      b.set('orientation', [0, 0, 1, -2.9]);
      close(hinge.get('angle') as number, 3.4 - 2 * Math.PI, 1e-5, 'rad, past half a turn');
      hinge.set('anchorPoint', [0, 0, 1]);
      close(hinge.get('angle') as number, 0, 1e-5, 'rad, made anew');
    },
  },
  {
    field: 'angleRate',
    fact: 'is the rate of body1 against body2 about the axis',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const [a, b] = [
        addBody(w, { angularVelocity: [0, 0, 2] }),
        addBody(w, { angularVelocity: [0, 0, -1] }),
      ];
      const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: a, body2: b, axis: [0, 0, 1] });
      w.step();
      close(hinge.get('angleRate') as number, 3, 1e-3, 'rad/s');
      a.set('angularVelocity', [0, 0, -3]);
      close(hinge.get('angleRate') as number, -2, 1e-3, 'rad/s, edited');
    },
  },
];

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
      const { joint, spinAfter } = await motor({
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
  ...[1, 2, 3].flatMap((n): Row[] => [
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
