import { guards } from './guards.js';

/** Wall time to fixed steps: an accumulator with a cap, so that a slow frame never breeds slower ones. */
export class Clock {
  /** Steps worth of time not taken yet, in seconds. */
  #rest = 0;

  /**
   * Longest stretch of simulated time one frame may catch up, seconds. A frame slower than this drops time
   * (reported as lag) instead of taking ever more steps.
   */
  static readonly LONGEST_FRAME = 0.1;

  /** Takes `seconds` of wall time; returns how many steps of `dt` are due and how many seconds were dropped. */
  advance(seconds: number, dt: number): { steps: number; dropped: number } {
    // A page's clock may stand still or go back; NaN would stop the world for good.
    if (!(seconds > 0)) return { steps: 0, dropped: 0 };
    const taken = guards.frameTime(seconds, Clock.LONGEST_FRAME);
    this.#rest += taken;
    // A hair of tolerance, so that 60 Hz frames against 1/120 s always make two steps in spite of rounding.
    const steps = Math.max(0, Math.floor(this.#rest / dt + 1e-6));
    this.#rest -= steps * dt;
    return { steps, dropped: seconds - taken };
  }

  /**
   * How far what is drawn lies between the last two steps: 0 at the last but one, 1 at the last. It lags behind the clock
   * by one step to come, `dt`; `last` is how long the last one was.
   */
  fraction(dt: number, last = dt): number {
    return Math.min(1, Math.max(0, 1 - (dt - this.#rest) / last));
  }

  /** Steps become longer by so many seconds, and what is drawn lags that much more behind: so that it goes on evenly, time is added. */
  lengthen(seconds: number): void {
    this.#rest += seconds;
  }

  reset(): void {
    this.#rest = 0;
  }
}
