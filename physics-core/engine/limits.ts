/** Lower and upper bound of one degree of freedom, body1 relative to body2. Lower above upper: free. */
export type Limit = readonly [number, number];

export const FREE: Limit = [1, -1];
/**
 * Not 0: Bullet's 6-DoF drops a locked row whose error is exactly the limit, so a hinge hanging straight would fall
 * for one step and be pulled back in the next, for ever (measured).
 */
export const LOCKED: Limit = [1e-20, 1e-20];

/** Stops as a limit: none where the lower lies above the upper, locked where both are one. */
export const between = (low: number, high: number): Limit =>
  low > high ? FREE : low < high ? [low, high] : low === 0 ? LOCKED : [low, low];
