import { CORNER } from '../../engine/contact-point.js';
import type { NewPoints } from '../../engine/manifold-writer.js';

/** Points that Bullet's manifolds hold. */
const MOST_POINTS = 4;

/** So many are found before those that are not needed are dropped. */
const MOST_FOUND = 96;

/** Two points so near each other are one, metres. */
const SAME = 1e-5;

/** Points so much less deep than the deepest are as deep, metres: which comes first is not to change from step to step. */
const AS_DEEP = 1e-5;

/** So much less deep the one that came first in the last step still does, metres. */
const STILL_FIRST = 1e-4;

/** The next of equals is taken only where it measures more than rounding, as a factor. */
const CLEARLY = 1.001;

/** m². */
const NO_AREA = 1e-12;

/** Contact points as they are found: where they lie on B, the normal from B into A, and the distance. */
export class FoundPoints implements NewPoints {
  count = 0;
  readonly at = new Float64Array(3 * MOST_FOUND);
  readonly normal = new Float64Array(3 * MOST_FOUND);
  readonly distance = new Float64Array(MOST_FOUND);
  /** The number of the triangle that each lies on. */
  readonly triangle = new Int32Array(MOST_FOUND);
  /** Whose corner it is that lies on a face of the other: `CORNER`. */
  readonly corner = new Int8Array(MOST_FOUND);
  /** Those to be kept. */
  readonly kept = new Int32Array(MOST_POINTS);
  keptCount = 0;
  /** Where the first one lay in the last step. */
  readonly #before = new Float64Array(3);
  #hasBefore = false;

  clear(): void {
    this.count = this.keptCount = 0;
    this.#hasBefore = false;
  }

  /** The first point of the last step lay here: others take its place only where they are clearly deeper. */
  setBefore(x: number, y: number, z: number): void {
    this.#before[0] = x;
    this.#before[1] = y;
    this.#before[2] = z;
    this.#hasBefore = true;
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
    corner: number = CORNER.ofNone,
  ): void {
    if (this.count === MOST_FOUND) this.#condense();
    const { at: places, normal } = this;
    const at = 3 * this.count;
    for (let i = 0; i < at; i += 3)
      if (
        Math.abs(places[i]! - x) + Math.abs(places[i + 1]! - y) + Math.abs(places[i + 2]! - z) <
          SAME &&
        normal[i]! * nx + normal[i + 1]! * ny + normal[i + 2]! * nz > 0.999
      )
        return;
    places[at] = x;
    places[at + 1] = y;
    places[at + 2] = z;
    normal[at] = nx;
    normal[at + 1] = ny;
    normal[at + 2] = nz;
    this.distance[this.count] = distance;
    this.corner[this.count] = corner;
    this.triangle[this.count++] = triangle;
  }

  /** A and B change places. */
  swap(): void {
    for (let i = 0; i < 3 * this.count; i++) {
      this.at[i]! += this.normal[i]! * this.distance[Math.floor(i / 3)]!;
      this.normal[i] = -this.normal[i]!;
    }
    for (let i = 0; i < this.count; i++) this.corner[i] = -this.corner[i]!;
  }

  /** The points of another. */
  take({ count, at, normal, distance, triangle, corner }: FoundPoints): void {
    for (let i = 0; i < count; i++) {
      const k = 3 * i;
      this.add(
        at[k]!,
        at[k + 1]!,
        at[k + 2]!,
        normal[k]!,
        normal[k + 1]!,
        normal[k + 2]!,
        distance[i]!,
        triangle[i]!,
        corner[i]!,
      );
    }
  }

  /** Only what would be kept of those found so far. */
  #condense(): void {
    this.reduce();
    this.kept.subarray(0, this.keptCount).sort();
    for (let i = 0; i < this.keptCount; i++) {
      const from = this.kept[i]!;
      for (let k = 0; k < 3; k++) {
        this.at[3 * i + k] = this.at[3 * from + k]!;
        this.normal[3 * i + k] = this.normal[3 * from + k]!;
      }
      this.distance[i] = this.distance[from]!;
      this.triangle[i] = this.triangle[from]!;
      this.corner[i] = this.corner[from]!;
    }
    this.count = this.keptCount;
  }

  /** Leaves four at most: the deepest, which is to stop a blow before the others, the one farthest from it, and those that make the largest face with both. */
  reduce(): void {
    this.keptCount = 0;
    if (this.count === 0) return;
    const first = this.#deepest();
    this.#keep(first);
    if (this.count <= MOST_POINTS) {
      for (let i = 0; i < this.count; i++) if (i !== first) this.#keep(i);
      return;
    }
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

  /** The least distance, metres; Infinity where nothing was found. */
  get least(): number {
    let least = Infinity;
    for (let i = 0; i < this.count; i++) least = Math.min(least, this.distance[i]!);
    return least;
  }

  #deepest(): number {
    const { least } = this;
    const before = this.#hasBefore ? this.#nearest(this.#before) : -1;
    if (before >= 0 && this.distance[before]! <= least + STILL_FIRST) return before;
    for (let i = 0; i < this.count; i++) if (this.distance[i]! <= least + AS_DEEP) return i;
    return 0;
  }

  #nearest(to: Float64Array): number {
    let least = Infinity;
    let found = -1;
    for (let i = 0; i < this.count; i++) {
      const x = this.at[3 * i]! - to[0]!;
      const y = this.at[3 * i + 1]! - to[1]!;
      const z = this.at[3 * i + 2]! - to[2]!;
      const apart = x * x + y * y + z * z;
      if (apart < least) {
        least = apart;
        found = i;
      }
    }
    return found;
  }

  #farthest(from: number): number {
    let most = 0;
    let found = -1;
    for (let i = 0; i < this.count; i++) {
      const apart = this.#apart(from, i);
      if (apart > most * CLEARLY) {
        most = apart;
        found = i;
      }
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
      if (area > most * CLEARLY) {
        most = area;
        found = i;
      }
    }
    return found;
  }

  #apart(i: number, j: number): number {
    const { at } = this;
    const x = at[3 * i]! - at[3 * j]!;
    const y = at[3 * i + 1]! - at[3 * j + 1]!;
    const z = at[3 * i + 2]! - at[3 * j + 2]!;
    return x * x + y * y + z * z;
  }

  /** Twice the area of a triangle of three points, seen along the normal of the first. */
  #area(i: number, j: number, k: number): number {
    const { at, normal } = this;
    const a = 3 * i;
    const b = 3 * j;
    const c = 3 * k;
    const ux = at[b]! - at[a]!;
    const uy = at[b + 1]! - at[a + 1]!;
    const uz = at[b + 2]! - at[a + 2]!;
    const vx = at[c]! - at[a]!;
    const vy = at[c + 1]! - at[a + 1]!;
    const vz = at[c + 2]! - at[a + 2]!;
    return (
      normal[0]! * (uy * vz - uz * vy) +
      normal[1]! * (uz * vx - ux * vz) +
      normal[2]! * (ux * vy - uy * vx)
    );
  }
}
