/** Share of the rate that its change in a step may be: what a blow did in the last step is no steady pull. */
const MOST_CHANGE = 0.25;

/**
 * How a joint meets a stop within a step: it runs up to it, is thrown back at its own time, and goes on for the rest of
 * the step. Rates are towards the stop; `near` is the distance to it per length of the step.
 */
export class StopBounce {
  /** The rate that it has in the middle of the step, as if it had been thrown back before; and the mean one. */
  rate = 0;
  mean = 0;

  /** `closing`: the rate in the middle of the last step; `change`: what a step adds to it. */
  meet(closing: number, change: number, near: number, bounce: number): void {
    const most = MOST_CHANGE * closing;
    const gained = Math.max(-most, Math.min(most, change));
    const start = closing + gained / 2;
    const way = Math.max(0, near);
    const hit = Math.sqrt(Math.max(0, start * start + 2 * gained * way));
    const until = Math.min(1, (2 * way) / (start + hit));
    const left = 1 - until;
    this.rate = -bounce * hit + gained * (0.5 - until);
    this.mean = Math.min(way, way - bounce * hit * left + (gained * left * left) / 2);
  }
}
