export { median } from './run/median.js';
import { median } from './run/median.js';

/** The middle of what was measured, and where it lies in 95 of 100 samples drawn again from the same numbers. */
export interface Estimate {
  median: number;
  low: number;
  high: number;
}

const SAMPLES = 2000;

/** Numbers from 0 to 1 that are the same each time, so that an estimate can be repeated from its numbers. */
function random(): () => number {
  let state = 1;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

/** Bootstrap: the 95 % interval of the median. */
export function estimate(values: readonly number[]): Estimate {
  const next = random();
  const again = (): number => median(values.map(() => values[Math.floor(next() * values.length)]!));
  const medians = Array.from({ length: SAMPLES }, again).sort((a, b) => a - b);
  const at = (share: number): number => medians[Math.round(share * (SAMPLES - 1))]!;
  return { median: median(values), low: at(0.025), high: at(0.975) };
}
