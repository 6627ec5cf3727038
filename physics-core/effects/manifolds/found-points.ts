import type { NewPoints } from '../../engine/manifold-writer.js';
import { MOST_CLIPPED } from './clip.js';

/** Points that Bullet's manifolds hold. */
const MOST_POINTS = 4;

/** Two points so near each other are one, metres. */
const SAME = 1e-5;

/** Points so much less deep than the deepest are as deep, metres: which comes first is not to change from step to step. */
const AS_DEEP = 1e-5;

/** The next of equals is taken only where it measures more than rounding, as a factor. */
const CLEARLY = 1.001;

/** m². */
const NO_AREA = 1e-12;

/** Contact points as they are found: where they lie on B, the normal from B into A, and the distance. */
export class FoundPoints implements NewPoints {
  count = 0;
  readonly at = new Float64Array(3 * MOST_CLIPPED);
  readonly normal = new Float64Array(3 * MOST_CLIPPED);
  readonly distance = new Float64Array(MOST_CLIPPED);
  /** The number of the triangle that each lies on. */
  readonly triangle = new Int32Array(MOST_CLIPPED);
  /** Those to be kept. */
  readonly kept = new Int32Array(MOST_POINTS);
  keptCount = 0;

  clear(): void {
    this.count = this.keptCount = 0;
  }

  add(
    x: number,
    y: number,
    z: number,
    nx: number,
    ny: number,
    nz: number,
    distance: number,
    triangle: number,
  ): void {
    const at = 3 * this.count;
    if (this.count === MOST_CLIPPED) return;
    for (let i = 0; i < at; i += 3)
      if (
        Math.abs(this.at[i]! - x) + Math.abs(this.at[i + 1]! - y) + Math.abs(this.at[i + 2]! - z) <
          SAME &&
        this.normal[i]! * nx + this.normal[i + 1]! * ny + this.normal[i + 2]! * nz > 0.999
      )
        return;
    this.at[at] = x;
    this.at[at + 1] = y;
    this.at[at + 2] = z;
    this.normal[at] = nx;
    this.normal[at + 1] = ny;
    this.normal[at + 2] = nz;
    this.distance[this.count] = distance;
    this.triangle[this.count++] = triangle;
  }

  /** Leaves four at most: the deepest, the one farthest from it, and those that make the largest face with both. */
  reduce(): void {
    this.keptCount = 0;
    if (this.count <= MOST_POINTS) {
      while (this.keptCount < this.count) this.kept[this.keptCount] = this.keptCount++;
      return;
    }
    const first = this.#deepest();
    this.#keep(first);
    const second = this.#farthest(first);
    this.#keep(second);
    if (second < 0) return;
    const third = this.#widest(first, second, 0);
    this.#keep(third);
    if (third < 0) return;
    const side = Math.sign(this.#area(first, second, third));
    this.#keep(this.#widest(first, second, -side, third));
  }

  #keep(number: number): void {
    if (number >= 0) this.kept[this.keptCount++] = number;
  }

  #deepest(): number {
    let least = Infinity;
    for (let i = 0; i < this.count; i++) least = Math.min(least, this.distance[i]!);
    for (let i = 0; i < this.count; i++) if (this.distance[i]! <= least + AS_DEEP) return i;
    return 0;
  }

  #farthest(from: number): number {
    let most = 0;
    let found = -1;
    for (let i = 0; i < this.count; i++) {
      const apart = this.#apart(from, i);
      if (apart > most * CLEARLY) [most, found] = [apart, i];
    }
    return found;
  }

  /**
   * What makes the largest triangle with two points, on either side of their line; `side` not 0: what lies on that side, or
   * outside the triangle with a third point, and adds most to it.
   */
  #widest(a: number, b: number, side: number, c = a): number {
    let most = NO_AREA;
    let found = -1;
    for (let i = 0; i < this.count; i++) {
      const first = this.#area(a, b, i);
      let area = side === 0 ? Math.abs(first) : side * first;
      if (c !== a) {
        area = Math.max(area, side * this.#area(b, c, i));
        area = Math.max(area, side * this.#area(c, a, i));
      }
      if (area > most * CLEARLY) [most, found] = [area, i];
    }
    return found;
  }

  #apart(i: number, j: number): number {
    let sum = 0;
    for (let k = 0; k < 3; k++) sum += (this.at[3 * i + k]! - this.at[3 * j + k]!) ** 2;
    return sum;
  }

  /** Twice the area of a triangle of three points, seen along the normal of the first. */
  #area(i: number, j: number, k: number): number {
    const { at, normal } = this;
    const [a, b, c] = [3 * i, 3 * j, 3 * k];
    const [ux, uy, uz] = [at[b]! - at[a]!, at[b + 1]! - at[a + 1]!, at[b + 2]! - at[a + 2]!];
    const [vx, vy, vz] = [at[c]! - at[a]!, at[c + 1]! - at[a + 1]!, at[c + 2]! - at[a + 2]!];
    return (
      normal[0]! * (uy * vz - uz * vy) +
      normal[1]! * (uz * vx - ux * vz) +
      normal[2]! * (ux * vy - uy * vx)
    );
  }
}
