import { guards } from './guards.js';

/** Wall time to fixed steps: an accumulator with a cap, so that a slow frame never breeds slower ones. */
export class Clock {
  /** Steps worth of time not taken yet, in seconds. */
  #rest = 0;

  /**
   * Longest stretch one frame may catch up, seconds of the clock. A frame slower than this drops time (reported as lag)
   * instead of taking ever more steps.
   */
  static readonly LONGEST_FRAME = 0.1;

  /** `seconds` of wall time have passed, each worth `scale` of simulated time. Returns how much of that is dropped. */
  add(seconds: number, scale = 1): number {
    // A page's clock may stand still or go back; NaN would stop the world for good.
    if (!(seconds > 0)) return 0;
    // In slow motion a slow frame is little work.
    const longest = Clock.LONGEST_FRAME * Math.max(1, scale);
    const taken = guards.frameTime(seconds * scale, longest);
    this.#rest += taken;
    return seconds * scale - taken;
  }

  /** Takes a step of `dt` where one is due. */
  take(dt: number): boolean {
    if (this.#due(dt) < 1) return false;
    this.#rest -= dt;
    return true;
  }

  /** Drops the steps that are due; returns how long they would have been, seconds. */
  drop(dt: number): number {
    const dropped = Math.max(0, this.#due(dt)) * dt;
    this.#rest -= dropped;
    return dropped;
  }

  /** A hair of tolerance, so that 60 Hz frames against 1/120 s always make two steps in spite of rounding. */
  #due(dt: number): number {
    return Math.floor(this.#rest / dt + 1e-6);
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
