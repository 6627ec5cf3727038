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

/** Bootstrap: where a statistic lies in 95 of 100 samples drawn again from the same ones. */
function intervalOf<T>(
  samples: readonly T[],
  statistic: (samples: readonly T[]) => number,
): { low: number; high: number } {
  const next = random();
  const again = (): number =>
    statistic(samples.map(() => samples[Math.floor(next() * samples.length)]!));
  const found = Array.from({ length: SAMPLES }, again).sort((a, b) => a - b);
  const at = (share: number): number => found[Math.round(share * (SAMPLES - 1))]!;
  return { low: at(0.025), high: at(0.975) };
}

/** Bootstrap: the 95 % interval of the median. */
export const estimate = (values: readonly number[]): Estimate => ({
  median: median(values),
  ...intervalOf(values, median),
});

/** All of one to all of the other, of pairs that were measured together, and its 95 % interval. */
export interface Share {
  mean: number;
  low: number;
  high: number;
}

export function shareOf(pairs: readonly (readonly [number, number])[]): Share {
  const sum = (i: 0 | 1, of: typeof pairs): number => of.reduce((all, pair) => all + pair[i], 0);
  const share = (of: typeof pairs): number => sum(0, of) / sum(1, of);
  return { mean: share(pairs), ...intervalOf(pairs, share) };
}

/** What that share of all does not exceed. */
const most = (values: readonly number[], share: number): number =>
  values.toSorted((a, b) => a - b)[Math.ceil(share * values.length) - 1]!;

/** What 95 of 100 do not exceed. */
export const ninetyFive = (values: readonly number[]): number => most(values, 0.95);

/** What 9 of 10 do not exceed. */
export const ninety = (values: readonly number[]): number => most(values, 0.9);
