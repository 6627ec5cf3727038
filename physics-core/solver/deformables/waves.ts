import { WAVE_CHANGE, WAVE_MARGIN, WAVE_ROUNDS } from '../tolerances.js';
import type { Masses } from './masses.js';

/** How far points are moved to see what forces do then, as a share of a length of what they are corners of. */
const SMALL = 1e-5;

/**
 * The square of the greatest frequency at `rest` of 1 kg of it, 1/s², all points being free. `push` adds to the
 * velocities what forces do in one second.
 */
export function quickest(
  masses: Masses,
  rest: Float64Array,
  length: number,
  push: () => void,
): number {
  let square = 0;
  masses.asLaid(() => (square = iterated(masses, rest, length, push)));
  return square > 0 && Number.isFinite(square) ? WAVE_MARGIN * square : 0;
}

/** Power iteration from a fixed start. */
function iterated(masses: Masses, rest: Float64Array, length: number, push: () => void): number {
  const { count, places, velocities } = masses;
  const mode = rough(3 * count);
  const answer = new Float64Array(3 * count);
  let square = 0;
  for (let round = 0, still = 0; round < WAVE_ROUNDS && still < 3; round++) {
    normalise(mode, masses.masses);
    answer.fill(0);
    for (const side of [1, -1]) {
      for (let j = 0; j < 3 * count; j++) places[j] = rest[j]! + side * SMALL * length * mode[j]!;
      velocities.fill(0);
      push();
      for (let j = 0; j < 3 * count; j++)
        answer[j]! -= (side * velocities[j]!) / (2 * SMALL * length);
    }
    const last = square;
    square = product(mode, answer, masses.masses) / product(mode, mode, masses.masses);
    still = Math.abs(square - last) <= WAVE_CHANGE * square ? still + 1 : 0;
    mode.set(answer);
  }
  return square;
}

/** The same numbers everywhere, of either sign, none of them like its neighbour. */
function rough(length: number): Float64Array {
  const numbers = new Float64Array(length);
  for (let j = 0, seed = 1; j < length; j++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    numbers[j] = seed / 2 ** 31 - 1;
  }
  return numbers;
}

/** The greatest of those that are moved is moved by 1. */
function normalise(mode: Float64Array, masses: Float64Array): void {
  let most = 0;
  for (let j = 0; j < mode.length; j++) {
    if (!(masses[Math.floor(j / 3)]! > 0)) mode[j] = 0;
    most = Math.max(most, Math.abs(mode[j]!));
  }
  if (most > 0) for (let j = 0; j < mode.length; j++) mode[j]! /= most;
}

function product(a: Float64Array, b: Float64Array, masses: Float64Array): number {
  let sum = 0;
  for (let j = 0; j < a.length; j++) sum += masses[Math.floor(j / 3)]! * a[j]! * b[j]!;
  return sum;
}
