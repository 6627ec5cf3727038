import { test } from 'node:test';
import { chainEnd, type Chain } from '../../../references/chain.js';
import { ballChain, boxChain } from '../../../references/chains.js';
import { cradleAngles } from '../../../references/cradle.js';
import { below, distance } from '../../core/helpers.js';

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

void test('the reference of chains is the same with half its step, within 1 µm', () => {
  for (const [chain, push] of [
    [ballChain(20), 0],
    [ballChain(1000), 0],
    [ballChain(1000), 0.5],
    [boxChain(8, 1), 0],
  ] as const) {
    const [whole, half] = [32, 64].map((steps) => chainEnd(chain, 2, steps, push));
    below(Math.max(...whole!.map((end, i) => distance(end, half![i]!))), 1e-6, 'm');
  }
});
