/** Milliseconds: the lesser of the clock, which other work moves on, and of the processor's time, which compilers beside us take, too. */
export function timeOf(step: () => void): number {
  const [start, before] = [performance.now(), process.cpuUsage()];
  step();
  const { user, system } = process.cpuUsage(before);
  return Math.min(performance.now() - start, (user + system) / 1000);
}
