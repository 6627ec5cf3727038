import type { Phase } from '../../effects/costs/phases.js';
import { userTiming } from '../../effects/costs/effects.js';
import type { Effects } from '../../effects/effect/effects.js';

/** What the phases of a frame take, milliseconds. */
export class PhaseCosts {
  readonly #effects: Effects;
  /** Of the last frame. */
  readonly ms = { step: 0, read: 0, write: 0, events: 0 };

  constructor(effects: Effects) {
    this.#effects = effects;
  }

  /** Of all but `write`, which ends a frame. */
  get beforeDrawing(): number {
    return this.ms.step + this.ms.read + this.ms.events;
  }

  clear(): void {
    this.ms.step = this.ms.read = this.ms.events = 0;
  }

  /** A phase of the present frame began at `start` and ends now; milliseconds it took. */
  spent(phase: Phase, start: number): number {
    const now = performance.now();
    this.ms[phase] += now - start;
    this.#effects.caused(userTiming)?.measure(phase, start, now);
    return now - start;
  }
}
