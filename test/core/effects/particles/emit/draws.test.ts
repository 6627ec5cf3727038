import assert from 'node:assert/strict';
import { Draws } from '../../../../../physics-core/effects/particles/emit/draws.js';
import { below, fact } from '../../../helpers.js';

const MANY = 50_000;

const list = (of: (draws: Draws, n: number) => number, seed = 7, from = 0): number[] => {
  const draws = new Draws(seed);
  return Array.from({ length: MANY }, (_, i) => of(draws, from + i));
};
const firsts = (seed?: number, from?: number): number[] =>
  list((draws, n) => draws.of(n).next(), seed, from);

const meanOf = (numbers: number[]): number =>
  numbers.reduce((sum, value) => sum + value, 0) / numbers.length;

/** Of two lists of even numbers below 1; a standard deviation of chance is 0.0045. */
const correlation = (a: number[], b: number[]): number =>
  12 * meanOf(a.map((value, i) => (value - 0.5) * (b[i]! - 0.5)));

function isEven(numbers: number[], what = ''): void {
  assert.ok(
    numbers.every((value) => value >= 0 && value < 1),
    what,
  );
  below(Math.abs(meanOf(numbers) / 0.5 - 1), 0.01, `mean ${what}`);
  below(Math.abs(correlation(numbers, numbers) - 1), 0.015, `variance ${what}`);
}

fact('drawn numbers are even from 0 to 1: mean 1/2, variance 1/12', () => {
  const numbers = firsts();
  isEven(numbers);
  const parts = new Array<number>(50).fill(0);
  for (const value of numbers) parts[Math.floor(value * 50)]!++;
  for (const part of parts) below(Math.abs(part / (MANY / 50) - 1), 0.13, 'part');
});

fact('the second number of a thing is as even, and so are the last digits', () => {
  isEven(list((draws, n) => (draws.of(n).next(), draws.next())));
  isEven(list((draws, n) => (draws.of(n).next() * 2 ** 27) % 1));
});

fact('numbers are whole multiples of 2^-53', () => {
  assert.ok(firsts().every((value) => Number.isInteger(value * 2 ** 53)));
  assert.ok(firsts().some((value) => !Number.isInteger(value * 2 ** 52)));
});

fact('numbers either way go from -1 to 1 with mean 0 and variance 1/3', () => {
  isEven(list((draws, n) => (draws.of(n).either() + 1) / 2));
});

fact('what one draws says nothing of what the next draws', () => {
  const numbers = firsts();
  below(Math.abs(correlation(numbers, firsts(7, 1))), 0.015);
  below(Math.abs(correlation(numbers, firsts(7, 2))), 0.015);
});

fact('the first number of one thing says nothing of its second, nor of its third', () => {
  const numbers = firsts();
  const second = list((draws, n) => (draws.of(n).next(), draws.next()));
  const third = list((draws, n) => (draws.of(n).next(), draws.next(), draws.next()));
  below(Math.abs(correlation(numbers, second)), 0.015);
  below(Math.abs(correlation(numbers, third)), 0.015);
});

fact('kinds have nothing to do with each other, and neither have seeds', () => {
  const numbers = firsts();
  const kinds = [1, 2, -1].map((kind) => list((draws, n) => draws.of(n, kind).next()));
  for (const other of [...kinds, firsts(8), firsts(-7), firsts(7 + 2 ** 32)])
    below(Math.abs(correlation(numbers, other)), 0.015);
});

fact('negative, fractional and huge seeds draw as evenly', () => {
  for (const seed of [-1, 0.5, -12345.678, 2 ** 31, 2 ** 40 + 5, 2 ** 53 - 1, -(2 ** 45)])
    isEven(firsts(seed), `seed ${seed}`);
});

fact('things far along a count, and before its begin, draw as evenly, each for itself', () => {
  const numbers = firsts();
  for (const from of [-MANY, 2 ** 31 - 100, 2 ** 32, 2 ** 40]) {
    const others = firsts(7, from);
    isEven(others, `from ${from}`);
    below(Math.abs(correlation(numbers, others)), 0.015, `from ${from}`);
  }
});

fact('numbers are the same whenever they are asked for, and whatever was asked before', () => {
  const draws = new Draws(3);
  const forth = [0, 1, 2, 2 ** 40].map((n) => [draws.of(n, 2).next(), draws.next()]);
  const back = [2 ** 40, 2, 1, 0].map((n) => {
    draws.of(n, 1).either();
    return [draws.of(n, 2).next(), draws.next()];
  });
  assert.deepEqual(back.reverse(), forth);
  assert.equal(new Set(forth.flat()).size, 8);
});

fact('numbers are the same to the last bit in every browser, and in every release', () => {
  const draws = new Draws(1);
  const bits = [draws.of(0).next(), draws.next(), draws.of(1).next(), draws.of(2 ** 40, 3).next()];
  assert.deepEqual(
    bits,
    [0.09798516519521883, 0.6162390713771186, 0.2960128747988726, 0.9908699216822664],
  );
});
