import type { Masses } from './masses.js';
import type { Threads } from './threads.js';

/**
 * Where two threads meet at a corner of a triangle: what makes their angle another than it was takes ½ G A (c - c0)², with A
 * the area of the triangle and c the product of both ways by both lengths.
 */
export class Corners {
  readonly count: number;
  /** The corner, and the ends of its two threads. */
  readonly #points: Int32Array;
  /** 1 / (product of lengths); the cosine as it was laid; the area. */
  readonly #scales: Float64Array;
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
    const corners: [points: number[], scale: number, rest: number, face: number][] = [];
    for (let f = 0; 3 * f + 2 < triangles.length; f++) {
      const face = [0, 1, 2].map((k) => triangles[3 * f + k]!);
      // Three threads hold their angles by themselves.
      const at = [0, 1, 2].filter((k) => !isThread(face[(k + 1) % 3]!, face[(k + 2) % 3]!));
      if (at.length !== 1) continue;
      const [o, a, b] = [face[at[0]!]!, face[(at[0]! + 1) % 3]!, face[(at[0]! + 2) % 3]!];
      const way = (p: number, k: number): number => places[3 * p + k]! - places[3 * o + k]!;
      const sum = (p: number, q: number): number =>
        [0, 1, 2].reduce((all, k) => all + way(p, k) * way(q, k), 0);
      const product = Math.sqrt(sum(a, a) * sum(b, b));
      if (product > 0) corners.push([[o, a, b], 1 / product, sum(a, b) / product, f]);
    }
    this.count = corners.length;
    this.#points = Int32Array.from(corners.flatMap(([all]) => all));
    this.#scales = Float64Array.from(corners, ([, scale]) => scale);
    this.#rest = Float64Array.from(corners, ([, , rest]) => rest);
    this.#areas = Float64Array.from(corners, ([, , , face]) => areas[face]!);
    this.#faces = Int32Array.from(corners, ([, , , face]) => face);
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
      const scale = this.#scales[n]!;
      const off = scale * (x * u + y * v + z * w) - this.#rest[n]!;
      const pull = time * stiffness * this.#areas[n]! * off * scale;
      const one = pull * inverse[a]!;
      const other = pull * inverse[b]!;
      const both = pull * inverse[o]!;
      velocities[3 * a]! -= one * u;
      velocities[3 * a + 1]! -= one * v;
      velocities[3 * a + 2]! -= one * w;
      velocities[3 * b]! -= other * x;
      velocities[3 * b + 1]! -= other * y;
      velocities[3 * b + 2]! -= other * z;
      velocities[3 * o]! += both * (x + u);
      velocities[3 * o + 1]! += both * (y + v);
      velocities[3 * o + 2]! += both * (z + w);
    }
  }

  /** For each point the most, 1/s² for each N/m, that any way of moving it is answered by. */
  addRates(rates: Float64Array, { masses }: Masses, places: ArrayLike<number>): void {
    for (let n = 0; n < this.count; n++) {
      const [o, a, b] = [0, 1, 2].map((k) => this.#points[3 * n + k]!) as [number, number, number];
      const length = (p: number): number =>
        Math.sqrt(
          [0, 1, 2].reduce((s, k) => s + (places[3 * p + k]! - places[3 * o + k]!) ** 2, 0),
        );
      const [one, other] = [length(a), length(b)];
      const share = this.#areas[n]! * this.#scales[n]! ** 2;
      const all = 2 * (one + other);
      rates[a]! += (share * other * all) / masses[a]!;
      rates[b]! += (share * one * all) / masses[b]!;
      rates[o]! += (share * (one + other) * all) / masses[o]!;
    }
  }
}
