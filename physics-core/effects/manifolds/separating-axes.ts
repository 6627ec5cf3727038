import { PointerNumbers } from '../../base/pointer-numbers.js';
import type { Flat } from '../../shapes/forms/form.js';
import type { PlacedForm } from './placed-form.js';

/** With more of them all are forgotten, and found again. */
const MOST_PAIRS = 2 ** 14;

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
    return apartAlong(a, b, this.#axes, 3 * number) > limit;
  }

  note(pair: number, axis: Flat): void {
    if (this.#pairs.count === MOST_PAIRS) this.#pairs.clear();
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

/** How far apart two forms are along a direction from B to A, metres. */
export function apartAlong(a: PlacedForm, b: PlacedForm, axis: Flat, at = 0): number {
  const x = axis[at]!;
  const y = axis[at + 1]!;
  const z = axis[at + 2]!;
  return -b.height(x, y, z) - a.height(-x, -y, -z);
}

/**
 * Turns a guess of where the normal points into that axis of either form along which they are farther apart, if there is one:
 * from the middle of a long floor to what rolls on its end the way is along the floor.
 */
export function preferAxes(a: PlacedForm, b: PlacedForm, normal: Flat): void {
  let most = apartAlong(a, b, normal);
  for (const { turn } of [a, b])
    for (let i = 0; i < 6; i++) {
      const sign = i < 3 ? 1 : -1;
      for (let k = 0; k < 3; k++) axis[k] = sign * turn[3 * k + (i % 3)]!;
      const apart = apartAlong(a, b, axis);
      if (!(apart > most)) continue;
      most = apart;
      for (let k = 0; k < 3; k++) normal[k] = axis[k]!;
    }
}

const axis = new Float64Array(3);
