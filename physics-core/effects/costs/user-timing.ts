import { Effect } from '../effect/effect.js';
import type { Phase } from './phases.js';

/** How browsers' Performance panels know what belongs on a track of its own. */
const TRACK = { devtools: { dataType: 'track-entry', track: 'x3d-physics' } };

/** Tells the browser's Performance panel of each phase (User Timing), while `world.profile` is true. */
export class UserTiming extends Effect {
  readonly #cause: { host: unknown } = { host: undefined };

  /** `host`: whose phases these are. */
  turn(on: boolean, host: unknown): void {
    this.#cause.host = host;
    if (on) this.need(this.#cause, 'profile');
    else this.release(this.#cause);
  }

  /** From `start` to `end`, on the clock of `performance.now()`. */
  measure(phase: Phase, start: number, end: number): void {
    const name = `x3d-physics ${phase}`;
    performance.measure(name, { start, end, detail: TRACK });
    // Panels and observers have heard of it; the page's own list would grow for ever.
    performance.clearMeasures(name);
  }
}
