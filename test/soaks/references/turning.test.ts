import { test } from 'node:test';
import { quaternionOf, rotate } from '../../../physics-core/base/math.js';
import { turn, type Turning } from '../../../references/turning.js';
import { below, distance } from '../../core/helpers.js';

// What the lab and the tests take for the truth: half the step must not change it.

const G = 9.81;

const turnings: Record<string, Turning> = {
  racket: { moments: [1, 2, 3], spin: [0.05, 3, 0.02] },
  top: {
    moments: [0.1533, 0.125, 0.1533],
    orientation: quaternionOf([0, 0, 1, -0.6]),
    spin: rotate(quaternionOf([0, 0, 1, -0.6]), [0, 30, 0]),
    arm: [0, 0.3, 0],
    weight: [0, -G, 0],
  },
};

for (const [name, turning] of Object.entries(turnings)) {
  void test(`${name}: half the step, the same turn`, () => {
    const [whole, half] = [turn(turning), turn(turning, 128)];
    for (let frame = 0; frame <= 300; frame++)
      below(distance(whole(frame), half(frame)), 1e-7, 'of the quaternion');
  });
}
