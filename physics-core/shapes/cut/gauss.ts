import { cos } from '../../base/exact/index.js';

/** Points of Gauss and Legendre's rule: what the frustum's sums need to be exact to twelve digits. */
const COUNT = 20;

const LAST = 1e-15;

/** Legendre's polynomial of that degree and its slope, by its recurrence. */
function legendre(x: number): { value: number; slope: number } {
  let before = 1;
  let value = x;
  for (let n = 2; n <= COUNT; n++)
    [before, value] = [value, ((2 * n - 1) * x * value - (n - 1) * before) / n];
  return { value, slope: (COUNT * (x * value - before)) / (x * x - 1) };
}

function root(i: number): number {
  let x = cos((Math.PI * (i + 0.75)) / (COUNT + 0.5));
  for (let tries = 0; tries < 9; tries++) {
    const { value, slope } = legendre(x);
    const step = value / slope;
    x -= step;
    if (Math.abs(step) < LAST) break;
  }
  return x;
}

/** Where between -1 and 1 a function is asked, and what each answer counts. */
export const NODES = Float64Array.from({ length: COUNT }, (_, i) => root(i));
export const WEIGHTS = NODES.map((x) => 2 / ((1 - x * x) * legendre(x).slope ** 2));
