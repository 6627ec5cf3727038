import { test } from 'node:test';
import { move, type Mechanism } from '../../references/mechanism.js';
import { below } from '../core/helpers.js';

// What the lab and the tests take for the truth: half the step must not change it.

const G = 9.81;

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
