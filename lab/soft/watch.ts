import type { SoftRunning } from './scene.js';

/** Steps for so many seconds; `look` sees each. */
export function goOn(running: SoftRunning, seconds: number, look?: (time: number) => void): void {
  const steps = Math.round(seconds / running.timeStep);
  for (let i = 1; i <= steps; i++) {
    running.step();
    look?.(i * running.timeStep);
  }
}

/** Of a parabola through three values, where the middle one is the greatest or the least; 0 where it is not. */
function crest(a: number, b: number, c: number): number {
  return (b - a) * (b - c) > 0 ? b - (a - c) ** 2 / (8 * (a - 2 * b + c)) : 0;
}

/** Of something that swings about 0: its mean period, seconds, and its greatest crest in the last quarter of the time. */
export function swingOf(
  running: SoftRunning,
  seconds: number,
  show: () => number,
): { period: number; most: number } {
  const crossings: number[] = [];
  let [last, before, most] = [0, show(), 0];
  goOn(running, seconds, (time) => {
    const now = show();
    if (before < 0 !== now < 0) crossings.push(time - (now / (now - before)) * running.timeStep);
    if (time > 0.75 * seconds) most = Math.max(most, Math.abs(crest(last, before, now)));
    [last, before] = [before, now];
  });
  return { period: (2 * (crossings.at(-1)! - crossings[0]!)) / (crossings.length - 1), most };
}
