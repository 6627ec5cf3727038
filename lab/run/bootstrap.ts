import { median } from './median.js';

const SAMPLES = 2000;

/** The interval that 95 % of the medians of samples drawn from the values lie in, the same in each run. */
export function medianInterval(values: readonly number[]): [number, number] {
  let state = 1;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
  const draw = () => values[Math.floor(random() * values.length)]!;
  const medians = Array.from({ length: SAMPLES }, () => median(values.map(draw)));
  medians.sort((a, b) => a - b);
  return [medians[Math.floor(0.025 * SAMPLES)]!, medians[Math.floor(0.975 * SAMPLES)]!];
}
