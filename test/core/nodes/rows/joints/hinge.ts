import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addJoint,
  close,
  spin,
  world,
  type Body,
  type Hinge,
  WEIGHTLESS,
} from '../../../helpers.js';
import { anchorPoint, bodies, forceOutput, outputAnchors } from './shared.js';
import type { Row } from '../row.js';

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
        ball.event('orientation', [0, 0, 1, 0]);
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
