import type { Edge } from './edges.js';
import { linesOf } from './lines.js';
import type { Masses } from './masses.js';
import { THREAD_COMPLIANCE, THREAD_RETURN } from '../tolerances.js';

/** The threads of a cloth, warp and weft: they stretch by their stiffness, or not at all. */
export class Threads {
  readonly count: number;
  readonly first: Int32Array;
  readonly second: Int32Array;
  readonly lengths: Float64Array;
  /** How many metres of cloth each stands for. */
  readonly widths: Float64Array;
  /** Which triangles each borders. */
  readonly faces: readonly (readonly number[])[];
  /** 1: it is torn. */
  readonly torn: Uint8Array;
  /** How much longer than it should be the most stretched one was when they were last gone over, as a share of its length. */
  strain = 0;

  /** Of each line its first thread; at the end how many there are. */
  readonly #starts: Int32Array;
  // Of one line: unit vectors along its threads; what is left of the elimination; how each is to be shortened.
  readonly #ways: Float64Array;
  readonly #diagonals: Float64Array;
  readonly #pulls: Float64Array;
  /** Of each thread, how much it was shortened in this part, kg m. */
  readonly #shortened: Float64Array;
  /** Of each point, what its threads answer it by: the six numbers of a symmetric matrix. */
  readonly #answers: Float64Array;

  constructor(edges: readonly Edge[], areas: Float64Array, places: ArrayLike<number>) {
    const { first, second, edges: threads, starts } = linesOf(places, edges);
    this.count = threads.length;
    this.first = Int32Array.from(first);
    this.second = Int32Array.from(second);
    this.lengths = Float64Array.from(threads, ({ length }) => length);
    this.widths = Float64Array.from(
      threads,
      ({ faces, length }) => faces.reduce((sum, f) => sum + areas[f]!, 0) / length,
    );
    this.faces = threads.map(({ faces }) => faces);
    this.torn = new Uint8Array(this.count);
    this.#shortened = new Float64Array(this.count);
    this.#answers = new Float64Array(2 * places.length);
    this.#starts = Int32Array.from(starts);
    const longest = starts.reduce(
      (most, start, i) => Math.max(most, (starts[i + 1] ?? 0) - start),
      0,
    );
    this.#ways = new Float64Array(3 * longest);
    this.#diagonals = new Float64Array(longest);
    this.#pulls = new Float64Array(longest);
  }

  /** The square of the greatest frequency that threads of 1 N/m can have, 1/s², all of a point side by side. */
  quickest({ inverse }: Masses): number {
    const { count, first, second, lengths, widths } = this;
    const sums = this.#answers.fill(0);
    for (let n = 0; n < count; n++) {
      const stiff = widths[n]! / lengths[n]!;
      sums[first[n]!]! += stiff;
      sums[second[n]!]! += stiff;
    }
    let most = 0;
    for (let i = 0; i < inverse.length; i++) most = Math.max(most, 2 * inverse[i]! * sums[i]!);
    return most;
  }

  /**
   * The same as they lie now, or a little more: k (d · (xᵢ − xⱼ))² of a thread along d is at most twice what each of its ends
   * has by itself. A stretched one is stiff across, too, as a string is.
   */
  quickestNow({ places, inverse }: Masses): number {
    const { count, first, second, lengths, widths, torn } = this;
    const answers = this.#answers.fill(0);
    for (let n = 0; n < count; n++) {
      if (torn[n] === 1) continue;
      const i = first[n]!;
      const j = second[n]!;
      const x = places[3 * j]! - places[3 * i]!;
      const y = places[3 * j + 1]! - places[3 * i + 1]!;
      const z = places[3 * j + 2]! - places[3 * i + 2]!;
      const now = Math.sqrt(x * x + y * y + z * z);
      if (!(now > 0)) continue;
      const stiff = widths[n]! / lengths[n]!;
      const across = stiff * Math.max(0, 1 - lengths[n]! / now);
      const along = (stiff - across) / (now * now);
      for (let at = 6 * i; ; at = 6 * j) {
        answers[at]! += along * x * x + across;
        answers[at + 1]! += along * y * y + across;
        answers[at + 2]! += along * z * z + across;
        answers[at + 3]! += along * x * y;
        answers[at + 4]! += along * y * z;
        answers[at + 5]! += along * z * x;
        if (at === 6 * j) break;
      }
    }
    let most = 0;
    for (let i = 0; i < inverse.length; i++)
      most = Math.max(most, 2 * inverse[i]! * largest(answers, 6 * i));
    return most;
  }

  /** Those that stretch pull by how far they do: N/m of each metre of width. */
  push({ places, velocities, inverse }: Masses, stiffness: number, time: number): void {
    const { count, first, second, lengths, widths, torn } = this;
    for (let n = 0; n < count; n++) {
      if (torn[n] === 1) continue;
      const i = 3 * first[n]!;
      const j = 3 * second[n]!;
      const x = places[j]! - places[i]!;
      const y = places[j + 1]! - places[i + 1]!;
      const z = places[j + 2]! - places[i + 2]!;
      const now = Math.sqrt(x * x + y * y + z * z);
      if (!(now > 0)) continue;
      const length = lengths[n]!;
      const pull = (time * stiffness * widths[n]! * (now - length)) / (length * now);
      const one = pull * inverse[first[n]!]!;
      const other = pull * inverse[second[n]!]!;
      velocities[i]! += one * x;
      velocities[i + 1]! += one * y;
      velocities[i + 2]! += one * z;
      velocities[j]! -= other * x;
      velocities[j + 1]! -= other * y;
      velocities[j + 2]! -= other * z;
    }
  }

  /**
   * One line after the other is taken to the lengths of its threads, or as far as `stiffness` takes them in such a time (0:
   * all the way). What each does to its neighbours in the line is solved for exactly, so that a sheet hangs as long as it is,
   * however many threads it has; warp and weft, which stand across, hardly feel each other. `again`: once more in this part.
   */
  hold(masses: Masses, stiffness: number, time: number, again: boolean): void {
    this.strain = 0;
    if (!again) this.#shortened.fill(0);
    const soft = stiffness > 0 ? 1 / (stiffness * time * time) : 0;
    const starts = this.#starts;
    for (let line = 0; line + 1 < starts.length; line++)
      this.#holdLine(masses, starts[line]!, starts[line + 1]!, soft, THREAD_RETURN * time);
  }

  /** A tridiagonal system (Thomas): how much each thread has to be shorter, kg m, in single steps of Newton. */
  #holdLine(
    { places, inverse }: Masses,
    from: number,
    to: number,
    soft: number,
    most: number,
  ): void {
    const { first, second, lengths, widths, torn } = this;
    const ways = this.#ways;
    const diagonals = this.#diagonals;
    const pulls = this.#pulls;
    let before = -1;
    for (let n = from, k = 0; n < to; n++, k++) {
      const i = 3 * first[n]!;
      const j = 3 * second[n]!;
      const x = places[j]! - places[i]!;
      const y = places[j + 1]! - places[i + 1]!;
      const z = places[j + 2]! - places[i + 2]!;
      const now = Math.sqrt(x * x + y * y + z * z);
      const gives = inverse[first[n]!]! + inverse[second[n]!]!;
      if (torn[n] === 1 || !(now > 0) || gives === 0) {
        diagonals[k] = 0;
        before = -1;
        continue;
      }
      ways[3 * k] = x / now;
      ways[3 * k + 1] = y / now;
      ways[3 * k + 2] = z / now;
      const gentle = soft > 0 ? (soft * lengths[n]!) / widths[n]! : 0;
      let off = now - lengths[n]! - gentle * this.#shortened[n]!;
      if (off > this.strain * lengths[n]!) this.strain = off / lengths[n]!;
      if (off > most) off = most;
      else if (off < -most) off = -most;
      let diagonal = gives * (1 + THREAD_COMPLIANCE) + gentle;
      if (before >= 0) {
        const beside = this.#beside(before, k, inverse[first[n]!]!);
        const share = beside / diagonals[before]!;
        diagonal -= share * beside;
        off -= share * pulls[before]!;
      }
      diagonals[k] = diagonal;
      pulls[k] = off;
      before = k;
    }
    let after = 0;
    for (let n = to - 1, k = to - 1 - from; n >= from; n--, k--) {
      if (diagonals[k] === 0) {
        after = 0;
        continue;
      }
      let pull = pulls[k]!;
      if (after !== 0) pull -= this.#beside(k, k + 1, inverse[second[n]!]!) * after;
      pull /= diagonals[k]!;
      after = pull;
      this.#shortened[n]! += pull;
      const one = pull * inverse[first[n]!]!;
      const other = pull * inverse[second[n]!]!;
      const i = 3 * first[n]!;
      const j = 3 * second[n]!;
      for (let c = 0; c < 3; c++) {
        places[i + c]! += one * ways[3 * k + c]!;
        places[j + c]! -= other * ways[3 * k + c]!;
      }
    }
  }

  /** What one thread of a line does to the next, by the point between them. */
  #beside(k: number, next: number, gives: number): number {
    const ways = this.#ways;
    return (
      -gives *
      (ways[3 * k]! * ways[3 * next]! +
        ways[3 * k + 1]! * ways[3 * next + 1]! +
        ways[3 * k + 2]! * ways[3 * next + 2]!)
    );
  }

  /** How much longer than its length the most stretched one is, as a share of that. */
  stretched({ places }: Masses): number {
    const { count, first, second, lengths, torn } = this;
    let most = 0;
    for (let n = 0; n < count; n++) {
      if (torn[n] === 1) continue;
      const i = 3 * first[n]!;
      const j = 3 * second[n]!;
      const x = places[j]! - places[i]!;
      const y = places[j + 1]! - places[i + 1]!;
      const z = places[j + 2]! - places[i + 2]!;
      most = Math.max(most, Math.sqrt(x * x + y * y + z * z) / lengths[n]! - 1);
    }
    return most;
  }

  /** Those that are stretched by more than a share of their length are no more. Answers whether any were. */
  tear({ places }: Masses, most: number): boolean {
    const { count, first, second, lengths, torn } = this;
    let any = false;
    for (let n = 0; n < count; n++) {
      if (torn[n] === 1) continue;
      const i = 3 * first[n]!;
      const j = 3 * second[n]!;
      const x = places[j]! - places[i]!;
      const y = places[j + 1]! - places[i + 1]!;
      const z = places[j + 2]! - places[i + 2]!;
      if (x * x + y * y + z * z <= ((1 + most) * lengths[n]!) ** 2) continue;
      torn[n] = 1;
      any = true;
    }
    return any;
  }
}

/** By which a symmetric matrix of xx, yy, zz, xy, yz, zx lengthens anything at most, or a little more: the greatest sum of a row. */
function largest(of: Float64Array, at: number): number {
  const xy = Math.abs(of[at + 3]!);
  const yz = Math.abs(of[at + 4]!);
  const zx = Math.abs(of[at + 5]!);
  return Math.max(of[at]! + xy + zx, of[at + 1]! + xy + yz, of[at + 2]! + yz + zx);
}
