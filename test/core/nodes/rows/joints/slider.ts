import assert from 'node:assert/strict';
import type { CreateOptions } from '../../../../../physics-core/create.js';
import type { SliderJointNode } from '../../../../../physics-core/nodes/joints/slider-joint-node.js';
import {
  addBody,
  claim,
  close,
  position,
  velocity,
  world,
  type Body,
  WEIGHTLESS,
} from '../../../helpers.js';
import { heard } from './shared.js';
import type { Row } from '../row.js';

/** A ball of 1 kg on an upright rail; Y up is positive. */
async function rail(fields: Record<string, unknown> = {}, settings: CreateOptions = {}) {
  const w = await world(settings);
  const ball = addBody(w);
  const slider = w.add('SliderJoint', { body1: ball, ...fields }) as SliderJointNode;
  w.step();
  return { w, ball, slider };
}

const wakes = (field: string, value: number): Row => ({
  field,
  fact: `an edit of ${field} wakes a sleeping bead`,
  run: async () => {
    const { w, ball, slider } = await rail({}, WEIGHTLESS);
    ball.sleep();
    w.step();
    assert.equal(ball.sleeping, true);
    slider.set(field, value);
    w.step();
    assert.equal(ball.sleeping, false);
  },
});

export const sliderRows: Row[] = [
  {
    field: 'minSeparation',
    effect: 'stops',
    fact: 'a bead rests on its lower stop under its weight, without a tremor',
    run: async () => {
      const { w, ball } = await rail({ minSeparation: -0.2 });
      w.advance(2);
      close(position(ball)[1], -0.2, 1e-6, 'm');
      close(velocity(ball)[1], 0, 1e-6, 'm/s');
    },
  },
  {
    field: 'stopBounce',
    effect: 'stops',
    fact: 'a bead that bounces fully comes back to its height every time',
    run: async () => {
      const { w, slider } = await rail({ minSeparation: -0.5, stopBounce: 1 });
      let highest = -1;
      for (let i = 0; i < 1200; i++) {
        w.step();
        if (i > 1000) highest = Math.max(highest, slider.separation);
      }
      // Half a step of the speed at the stop, 3.1 m/s, is 1.3 cm; it does not add up.
      close(highest, 0, 2e-3, 'm');
    },
  },
  {
    field: 'minSeparation',
    effect: 'stops',
    fact: 'a stop is told once when it is reached, and again after it was left',
    run: async () => {
      const { w, ball, slider } = await rail({ minSeparation: -0.2, maxSeparation: 0.1 });
      const limits = heard(slider);
      w.advance(1);
      assert.deepEqual(limits.splice(0), [{ limit: 'min', value: -0.2 }]);
      ball.event('linearVelocity', [0, 4, 0]);
      w.advance(1);
      assert.deepEqual(limits, [
        { limit: 'max', value: 0.1 },
        { limit: 'min', value: -0.2 },
      ]);
    },
  },
  {
    field: 'maxSeparation',
    effect: 'stops',
    fact: 'body2 slides apart from body1 in front of it, and its stop is told by the fields, not by the axis',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const pin = addBody(w, { fixed: true });
      const ball = addBody(w, { position: [0, 2, 0], linearVelocity: [0, 3, 0] });
      const slider = w.add('SliderJoint', { body1: pin, body2: ball, maxSeparation: 0.5 });
      const limits = heard(slider);
      w.advance(0.5);
      close(position(ball)[1], 2.5, 1e-4, 'm');
      assert.deepEqual(limits, [{ limit: 'max', value: 0.5 }]);
    },
  },
  {
    field: 'axis',
    fact: 'without a direction the default is used, and its author is told until it has one',
    run: async () => {
      const { w, ball, slider } = await rail({ minSeparation: 1, maxSeparation: 0 }, WEIGHTLESS);
      claim(w, 'bad-value');
      slider.set('axis', [0, 0, 0]);
      w.step();
      assert.deepEqual(
        w.problems.map(({ code, attribute, used }) => [code, attribute, used]),
        [['bad-value', 'axis', [0, 1, 0]]],
      );
      ball.event('linearVelocity', [1, 1, 1]);
      w.step();
      close(velocity(ball), [0, 1, 0], 1e-5, 'm/s');
      slider.set('axis', [1, 0, 0]);
      w.step();
      assert.deepEqual(w.problems, []);
    },
  },
  {
    field: 'sliderForce',
    effect: 'motors',
    fact: 'acts as long as it is asked for, and no longer',
    run: async () => {
      const { w, ball, slider } = await rail(
        { minSeparation: 1, maxSeparation: 0, sliderForce: 2 },
        WEIGHTLESS,
      );
      w.advance(0.5);
      const speed = velocity(ball)[1];
      slider.unset('sliderForce');
      w.advance(0.5);
      close(velocity(ball)[1], speed, 1e-6, 'm/s');
      const motors = () => w.effects.find(({ name }) => name === 'motors')!.active;
      assert.equal(motors(), false);
      slider.set('sliderForce', 1);
      w.step();
      assert.equal(motors(), true);
      slider.remove();
      assert.equal(motors(), false);
    },
  },
  ...(['body1', 'body2'] as const).map((field): Row => ({
    field,
    fact: 'may come late, be fixed and let go again, and be taken away: the rail keeps its zero',
    run: async () => {
      const w = await world(WEIGHTLESS);
      const slider = w.add('SliderJoint', {
        axis: [1, 0, 0],
        minSeparation: 1,
        maxSeparation: 0,
      }) as SliderJointNode;
      claim(w, 'no-body');
      w.advance(0.1);
      const ball: Body = addBody(w, { linearVelocity: [1, 1, 0] });
      slider.set(field, ball);
      w.advance(0.5);
      close(velocity(ball), [1, 0, 0], 1e-5, 'm/s');
      const away = slider.separation;
      close(Math.abs(away), 0.5, 1e-2, 'm');
      ball.set('fixed', true);
      w.advance(0.1);
      ball.set('fixed', false);
      ball.event('linearVelocity', [0, 1, 0]);
      w.advance(0.1);
      close(slider.separation, away, 1e-6, 'm, as before');
      close(velocity(ball), [0, 0, 0], 1e-4, 'm/s');
      slider.set(field, null);
      ball.event('linearVelocity', [0, 1, 0]);
      w.advance(0.1);
      close(velocity(ball), [0, 1, 0], 1e-6, 'm/s, free');
    },
  })),
  wakes('stopBounce', 0.5),
  wakes('stopErrorCorrection', 0.5),
  wakes('maxSeparation', 2),
  wakes('sliderForce', 1),
];
