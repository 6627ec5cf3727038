import { cos, exp, sin } from '../../base/exact/index.js';
import { expm1 } from '../../base/exact/expm1.js';

/** Least ω² by δ² at which a load's share can still be told from rounding. */
const LEAST_SPRING = 1e-6;

/**
 * One step of x'' + 2 δ x' + ω² x = a, solved exactly: the mean rate over the next step is
 * `kept` · rate - `pull` · x + `load` · a, with the rate at this moment or, once it is on its way, the mean one of the
 * step before. Never unstable, however stiff.
 */
export class Oscillator {
  kept = 0;
  pull = 0;
  load = 0;

  /** From the mean rate of the last step. */
  goOn(omega2: number, delta: number, dt: number): void {
    const w2 = omega2 - delta * delta;
    if (w2 > 0) {
      const left = exp(-delta * dt);
      this.kept = left * left;
      this.load = (1 + this.kept - 2 * left * cos(Math.sqrt(w2) * dt)) / (dt * omega2);
    } else {
      const fast = delta + Math.sqrt(-w2);
      const slow = omega2 / fast;
      this.kept = exp(-2 * delta * dt);
      this.load = (decayed(slow, dt) * decayed(fast, dt)) / dt;
    }
    this.pull = this.load * omega2;
  }

  /** From the rate at this moment. */
  start(omega2: number, delta: number, dt: number): void {
    const spring = Math.max(omega2, LEAST_SPRING * delta * delta);
    const w2 = spring - delta * delta;
    const w = Math.sqrt(Math.abs(w2));
    let even: number;
    let odd: number;
    if (w2 > 0) {
      const left = exp(-delta * dt);
      even = left * cos(w * dt);
      odd = (left * sin(w * dt)) / w;
    } else {
      const slow = exp((w - delta) * dt);
      const fast = exp(-(w + delta) * dt);
      even = (slow + fast) / 2;
      odd = w > 0 ? (slow - fast) / (2 * w) : dt * slow;
    }
    this.kept = odd / dt;
    this.load = (1 - even - delta * odd) / (dt * spring);
    this.pull = this.load * omega2;
  }
}

/** Seconds that a rate counts for which decays at `rate`. */
const decayed = (rate: number, dt: number): number => (rate > 0 ? -expm1(-rate * dt) / rate : dt);
