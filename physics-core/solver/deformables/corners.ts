import type { Masses } from './masses.js';
import type { Threads } from './threads.js';

/**
 * Where two threads meet at a corner of a triangle: what makes their angle another than it was takes ½ G A (c - c0)², with A
 * the area of the triangle and c the cosine of the angle.
 */
export class Corners {
  readonly count: number;
  /** The corner, and the ends of its two threads. */
  readonly #points: Int32Array;
  /** Lengths of both threads, the cosine as it was laid, and the area. */
  readonly #firsts: Float64Array;
  readonly #seconds: Float64Array;
  readonly #rest: Float64Array;
  readonly #areas: Float64Array;
  /** In which triangle each is. */
  readonly #faces: Int32Array;

  constructor(
    places: ArrayLike<number>,
    triangles: ArrayLike<number>,
    areas: Float64Array,
    threads: Threads,
  ) {
    const points = places.length / 3;
    const known = new Set<number>();
    for (let n = 0; n < threads.count; n++)
      known.add(threads.first[n]! * points + threads.second[n]!);
    const isThread = (a: number, b: number): boolean =>
      known.has(Math.min(a, b) * points + Math.max(a, b));
    const corners: [points: number[], one: number, other: number, rest: number, face: number][] =
      [];
    for (let f = 0; 3 * f + 2 < triangles.length; f++) {
      const face = [0, 1, 2].map((k) => triangles[3 * f + k]!);
      // Three threads hold their angles by themselves.
      const at = [0, 1, 2].filter((k) => !isThread(face[(k + 1) % 3]!, face[(k + 2) % 3]!));
      if (at.length !== 1) continue;
      const o = face[at[0]!]!;
      const a = face[(at[0]! + 1) % 3]!;
      const b = face[(at[0]! + 2) % 3]!;
      const way = (p: number, k: number): number => places[3 * p + k]! - places[3 * o + k]!;
      const sum = (p: number, q: number): number =>
        [0, 1, 2].reduce((all, k) => all + way(p, k) * way(q, k), 0);
      const one = Math.sqrt(sum(a, a));
      const other = Math.sqrt(sum(b, b));
      if (one > 0 && other > 0) corners.push([[o, a, b], one, other, sum(a, b) / (one * other), f]);
    }
    this.count = corners.length;
    this.#points = Int32Array.from(corners.flatMap(([all]) => all));
    this.#firsts = Float64Array.from(corners, ([, one]) => one);
    this.#seconds = Float64Array.from(corners, ([, , other]) => other);
    this.#rest = Float64Array.from(corners, ([, , , rest]) => rest);
    this.#areas = Float64Array.from(corners, ([, , , , face]) => areas[face]!);
    this.#faces = Int32Array.from(corners, ([, , , , face]) => face);
  }

  /** N/m; those of triangles that are gone do nothing. */
  push(
    { places, velocities, inverse }: Masses,
    stiffness: number,
    time: number,
    gone: Uint8Array,
  ): void {
    for (let n = 0; n < this.count; n++) {
      if (gone[this.#faces[n]!] === 1) continue;
      const o = this.#points[3 * n]!;
      const a = this.#points[3 * n + 1]!;
      const b = this.#points[3 * n + 2]!;
      const x = places[3 * a]! - places[3 * o]!;
      const y = places[3 * a + 1]! - places[3 * o + 1]!;
      const z = places[3 * a + 2]! - places[3 * o + 2]!;
      const u = places[3 * b]! - places[3 * o]!;
      const v = places[3 * b + 1]! - places[3 * o + 1]!;
      const w = places[3 * b + 2]! - places[3 * o + 2]!;
      const one = Math.sqrt(x * x + y * y + z * z);
      const other = Math.sqrt(u * u + v * v + w * w);
      if (!(one > 0 && other > 0)) continue;
      const cosine = (x * u + y * v + z * w) / (one * other);
      const pull = time * stiffness * this.#areas[n]! * (cosine - this.#rest[n]!);
      // What has all but shrunk to a point would turn without end.
      const first = pull / (one * Math.max(one, this.#firsts[n]! / 2));
      const second = pull / (other * Math.max(other, this.#seconds[n]! / 2));
      const ax = first * ((u * one) / other - cosine * x);
      const ay = first * ((v * one) / other - cosine * y);
      const az = first * ((w * one) / other - cosine * z);
      const bx = second * ((x * other) / one - cosine * u);
      const by = second * ((y * other) / one - cosine * v);
      const bz = second * ((z * other) / one - cosine * w);
      velocities[3 * a]! -= inverse[a]! * ax;
      velocities[3 * a + 1]! -= inverse[a]! * ay;
      velocities[3 * a + 2]! -= inverse[a]! * az;
      velocities[3 * b]! -= inverse[b]! * bx;
      velocities[3 * b + 1]! -= inverse[b]! * by;
      velocities[3 * b + 2]! -= inverse[b]! * bz;
      velocities[3 * o]! += inverse[o]! * (ax + bx);
      velocities[3 * o + 1]! += inverse[o]! * (ay + by);
      velocities[3 * o + 2]! += inverse[o]! * (az + bz);
    }
  }

  /** For each point the most, 1/s² for each N/m, that any way of moving it is answered by. */
  addRates(rates: Float64Array, { masses }: Masses): void {
    for (let n = 0; n < this.count; n++) {
      const [o, a, b] = [0, 1, 2].map((k) => this.#points[3 * n + k]!) as [number, number, number];
      const one = 1 / this.#firsts[n]!;
      const other = 1 / this.#seconds[n]!;
      const all = 2 * this.#areas[n]! * (one + other);
      rates[a]! += (all * one) / masses[a]!;
      rates[b]! += (all * other) / masses[b]!;
      rates[o]! += (all * (one + other)) / masses[o]!;
    }
  }
}
