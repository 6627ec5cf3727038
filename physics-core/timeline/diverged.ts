import type { World } from '../world/world.js';

/** What was run anew is elsewhere at a step than it was then. */
export const reportDiverged = (world: World, step: number, time: number): void =>
  world.report({
    code: 'run-diverged',
    severity: 'warning',
    value: step,
    message: `at step ${step}, ${time.toFixed(2)} s, what is run anew is not where it was then`,
  });
