import { Effect, type Cause } from '../effect/effect.js';
import { Pace } from './pace.js';
import { PHASES, type Costs, type Percentiles, type Phase } from './phases.js';

/** Frames that are looked back on: four seconds at 60 Hz, so that p99 stands on more than one of them. */
const WINDOW = 240;

/** What frames cost, kept while somebody looks: a monitor. */
export class FrameCosts extends Effect {
  /** Per frame the phases one after another; the oldest is overwritten. */
  #ring: Float64Array | undefined;
  #pace: Pace | undefined;
  #frames = 0;
  /** Steps of the present frame. */
  #steps = 0;

  /** Keeps costs until the returned function is called; `who` stands in `world.effects`. */
  record(who: unknown, reason: string): () => void {
    const cause: Cause = { host: who };
    this.need(cause, reason);
    return () => {
      this.release(cause);
      if (!this.active) this.#forget();
    };
  }

  #forget(): void {
    this.#ring = this.#pace = undefined;
    this.#frames = this.#steps = 0;
  }

  override afterStep(): void {
    this.#steps++;
  }

  /** A frame is drawn, `seconds` after the last one (0: it follows none), in so many milliseconds beside `write`. */
  frameOver(ms: Readonly<Record<Phase, number>>, seconds = 0, picture = 0): void {
    if (!this.active) return;
    const steps = this.#steps;
    this.#steps = 0;
    if (seconds > 0) {
      this.#pace ??= new Pace();
      this.#pace.add(seconds, steps, ms.step + ms.read, ms.events, ms.write + picture);
    }
    if (steps > 0) this.#keep(ms);
  }

  /** A frame without a step says nothing of what steps cost. */
  #keep(ms: Readonly<Record<Phase, number>>): void {
    const ring = (this.#ring ??= new Float64Array(WINDOW * PHASES.length));
    const at = (this.#frames++ % WINDOW) * PHASES.length;
    for (let i = 0; i < PHASES.length; i++) ring[at + i] = ms[PHASES[i]!];
  }

  /** Undefined while nobody looks or nothing moved yet. */
  get report(): Costs | undefined {
    const ring = this.#ring;
    if (!ring) return undefined;
    const frames = Math.min(this.#frames, WINDOW);
    const rows = Array.from({ length: frames }, (_, i) =>
      ring.subarray(i * PHASES.length, (i + 1) * PHASES.length),
    );
    const of = (phase: number): Percentiles => percentiles(rows.map((row) => row[phase]!));
    const total = percentiles(rows.map((row) => row.reduce((sum, value) => sum + value, 0)));
    const pace = this.#pace?.report;
    return { frames, step: of(0), read: of(1), write: of(2), events: of(3), total, pace };
  }
}

/** By nearest rank: the least value that so many of a hundred do not exceed. */
function percentiles(values: number[]): Percentiles {
  const sorted = values.sort((a, b) => a - b);
  const rank = (share: number): number => sorted[Math.ceil(share * sorted.length) - 1]!;
  return { p50: rank(0.5), p90: rank(0.9), p99: rank(0.99) };
}
