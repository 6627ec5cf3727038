import { PointerNumbers } from '../../base/pointer-numbers.js';
import type { Flat } from '../../shapes/forms/form.js';
import type { PlacedForm } from './placed-form.js';

/**
 * The direction along which a pair was found apart last. What is farther apart than a limit along any direction is so in
 * truth: nothing but the time of a step hangs on what is kept here.
 */
export class SeparatingAxes {
  readonly #pairs = new PointerNumbers();
  /** From B into A. */
  #axes = new Float64Array(3 * 64);

  /** Whether the direction still separates them by more than `limit`, metres; `pair`: any number but 0 that stands for both. */
  separates(pair: number, a: PlacedForm, b: PlacedForm, limit: number): boolean {
    const number = this.#pairs.find(pair);
    if (number < 0) return false;
    const at = 3 * number;
    const x = this.#axes[at]!;
    const y = this.#axes[at + 1]!;
    const z = this.#axes[at + 2]!;
    return -b.height(x, y, z) - a.height(-x, -y, -z) > limit;
  }

  note(pair: number, axis: Flat): void {
    const at = 3 * this.#pairs.numberOf(pair);
    if (at >= this.#axes.length) this.#grow();
    for (let k = 0; k < 3; k++) this.#axes[at + k] = axis[k]!;
  }

  #grow(): void {
    const before = this.#axes;
    this.#axes = new Float64Array(2 * before.length);
    this.#axes.set(before);
  }
}
