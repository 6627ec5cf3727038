import { test } from 'node:test';
import { quaternionOf, rotate } from '../../physics-core/base/math.js';
import { chainEnd, type Chain } from '../../references/chain.js';
import { ballChain, boxChain } from '../../references/chains.js';
import { cradleAngles } from '../../references/cradle.js';
import { move, type Mechanism } from '../../references/mechanism.js';
import { turn, type Turning } from '../../references/turning.js';
import { below, distance } from './helpers.js';

// What the lab and the tests take for the truth: half the step must not change it.

const G = 9.81;

const chains: Record<string, [Chain, seconds: number, perFrame: number, tolerance: number]> = {
  'double pendulum': [boxChain(2, 0.5), 2, 32, 1e-8],
  'chain 1:20': [ballChain(20), 1, 64, 1e-8],
  'chain 1:1000': [ballChain(1000), 1, 64, 1e-6],
  'chain of 100': [boxChain(100), 0.25, 16, 1e-7],
};

for (const [name, [chain, seconds, perFrame, tolerance]] of Object.entries(chains)) {
  void test(`${name}: half the step, the same way`, () => {
    const [whole, half] = [1, 2].map((n) => chainEnd(chain, seconds, perFrame * n)) as number[][][];
    whole!.forEach((end, frame) => below(distance(end, half![frame]!), tolerance, 'm'));
  });
}

void test('cradle: half the step, the same places', () => {
  const cradle = { count: 5, radius: 0.1, gap: 0.001, arm: 1, gravity: G };
  const [whole, half] = [128, 256].map((n) => cradleAngles(cradle, Math.PI / 6, 1.5, n));
  whole!.forEach((angles, frame) => below(distance(angles, half![frame]!), 1e-8, 'rad'));
});

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

const mechanisms: Record<string, [Mechanism, at: number, rate: number]> = {
  pendulum: [
    {
      places: (at) => [at, -Math.sin(at), Math.cos(at)],
      inertias: [0.004, 1, 1],
      pulls: [0, -G],
    },
    0,
    0,
  ],
  'slider-crank': [
    {
      places: (at) => [at, 0.3 * Math.cos(at) + Math.sqrt(1 - (0.3 * Math.sin(at)) ** 2)],
      inertias: [0.5, 1],
    },
    0,
    4,
  ],
};

for (const [name, [mechanism, at, rate]] of Object.entries(mechanisms)) {
  void test(`${name}: half the step, the same motion`, () => {
    const [whole, half] = [move(mechanism, at, rate), move(mechanism, at, rate, 32)];
    for (let frame = 0; frame <= 300; frame++)
      below(Math.abs(whole(frame).at - half(frame).at), 1e-7, 'rad');
  });

  void test(`${name}: its energy stays`, () => {
    const states = move(mechanism, at, rate);
    const energy = (frame: number): number => {
      const state = states(frame);
      const little = 1e-4;
      const [a, b] = [-1, 1].map((s) => mechanism.places(state.at + s * little)) as number[][];
      return mechanism.inertias.reduce((sum, inertia, i) => {
        const speed = ((b![i]! - a![i]!) / (2 * little)) * state.rate;
        const high = (mechanism.pulls?.[i] ?? 0) * mechanism.places(state.at)[i]!;
        return sum + (inertia * speed * speed) / 2 - high;
      }, 0);
    };
    for (let frame = 0; frame <= 300; frame++)
      below(Math.abs(energy(frame) - energy(0)), 1e-6, 'J');
  });
}
