/** Milliseconds. Facts of the core in Node stop `performance.now()`, as they count steps. */
const now = (): number =>
  typeof process === 'undefined' ? performance.now() : Number(process.hrtime.bigint()) / 1e6;

/**
 * How many square roots of each of so many numbers take the time of `work`: what is asked of code that goes once through
 * its numbers, in the same run and whatever the machine is like. The best of five turns of each, side by side; a turn has
 * eight million roots, since clocks of pages tell milliseconds.
 */
export function inRoots(work: () => void, count: number): number {
  const numbers = new Float32Array(count);
  const roots = (): void => {
    for (let i = 0; i < count; i++) numbers[i] = Math.sqrt(i + numbers[i]!);
  };
  const times = Math.ceil(8e6 / count);
  const best = [Infinity, Infinity];
  for (let turn = 0; turn < 5; turn++)
    [work, roots].forEach((act, which) => {
      const start = now();
      for (let i = 0; i < times; i++) act();
      best[which] = Math.min(best[which]!, now() - start);
    });
  return best[0]! / best[1]!;
}
