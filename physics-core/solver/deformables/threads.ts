import { coloured, type Edge } from './edges.js';
import type { Masses } from './masses.js';

/** The threads of a cloth, warp and weft: they stretch by their stiffness, or not at all. */
export class Threads {
  readonly count: number;
  readonly first: Int32Array;
  readonly second: Int32Array;
  readonly lengths: Float64Array;
  /** How many metres of cloth each stands for. */
  readonly widths: Float64Array;
  /** 1: it is torn. */
  readonly torn: Uint8Array;
  /** They are gone over from the first to the last and back in turns: neither side comes first. */
  readonly turns = new Uint8Array(1);
  /** How much longer than its length the most stretched one was when they were last gone over, as a share of that. */
  strain = 0;

  constructor(edges: readonly Edge[], areas: Float64Array, points: number) {
    const threads = edges.filter(({ thread, length }) => thread && length > 0);
    const order = coloured(threads, points);
    this.count = threads.length;
    this.first = Int32Array.from(order, (i) => threads[i]!.a);
    this.second = Int32Array.from(order, (i) => threads[i]!.b);
    this.lengths = Float64Array.from(order, (i) => threads[i]!.length);
    this.widths = Float64Array.from(order, (i) => {
      const { faces, length } = threads[i]!;
      return faces.reduce((sum, f) => sum + areas[f]!, 0) / length;
    });
    this.torn = new Uint8Array(this.count);
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
   * One after the other is taken to its length, or as far as `stiffness` takes it in such a time (0: all the way): no two of
   * one colour share a point.
   */
  hold({ places, inverse }: Masses, stiffness: number, time: number): void {
    const { count, first, second, lengths, widths, torn } = this;
    const soft = stiffness > 0 ? 1 / (stiffness * time * time) : 0;
    let strain = 0;
    this.turns[0]! ^= 1;
    for (let m = 0; m < count; m++) {
      const n = this.turns[0] === 1 ? m : count - 1 - m;
      if (torn[n] === 1) continue;
      const a = first[n]!;
      const b = second[n]!;
      const length = lengths[n]!;
      const gives = inverse[a]! + inverse[b]!;
      if (gives === 0) continue;
      const i = 3 * a;
      const j = 3 * b;
      const x = places[j]! - places[i]!;
      const y = places[j + 1]! - places[i + 1]!;
      const z = places[j + 2]! - places[i + 2]!;
      const now = Math.sqrt(x * x + y * y + z * z);
      if (!(now > 0)) continue;
      const off = now - length;
      if (off > strain * length) strain = off / length;
      const share = off / (now * (gives + (soft * length) / widths[n]!));
      const one = share * inverse[a]!;
      const other = share * inverse[b]!;
      places[i]! += one * x;
      places[i + 1]! += one * y;
      places[i + 2]! += one * z;
      places[j]! -= other * x;
      places[j + 1]! -= other * y;
      places[j + 2]! -= other * z;
    }
    this.strain = strain;
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
