import { SEAM } from './layout.js';

/** A neighbour that rises or falls less, by the sine of the angle, goes on in the same plane. */
const FLAT = 1e-5;

/** A corner may stand so far out, by the sine of the angle, and another still bears what touches them. */
const STANDS_OUT = 1e-3;

/**
 * How triangles hang together, by the places of their corners: what is beyond their sides, and which corners are next to which.
 * What touches an edge or a corner does so only from where no neighbour is in the way.
 */
export class Seams {
  readonly #points: Float64Array;
  readonly #index: Int32Array;
  /** Of the sides of each triangle, from each corner to the next, one of SEAM. */
  readonly beyond: Int8Array;
  /** Each corner as the first one in its place. */
  readonly #same: Int32Array;
  /** Of each such corner, where the list of those next to it begins. */
  readonly #from: Int32Array;
  readonly #next: Int32Array;

  constructor(points: Float64Array, index: Int32Array, normals: Float64Array) {
    this.#points = points;
    this.#index = index;
    this.#same = firstInPlace(points);
    const next = Array.from({ length: points.length / 3 }, () => new Set<number>());
    this.#eachSide((_, from, to) => {
      next[from]!.add(to);
      next[to]!.add(from);
    });
    this.#from = new Int32Array(next.length + 1);
    next.forEach((all, i) => (this.#from[i + 1] = this.#from[i]! + all.size));
    this.#next = Int32Array.from(next.flatMap((all) => [...all]));
    this.beyond = this.#beyond(normals);
  }

  #eachSide(visit: (side: number, from: number, to: number) => void): void {
    for (let t = 0; t < this.#index.length; t++) {
      const first = t - (t % 3);
      const other = first + ((t + 1) % 3);
      visit(t, this.#same[this.#index[t]!]!, this.#same[this.#index[other]!]!);
    }
  }

  #beyond(normals: Float64Array): Int8Array {
    const beyond = new Int8Array(this.#index.length).fill(SEAM.nothing);
    const seen = new Map<number, number>();
    const corners = this.#points.length / 3;
    this.#eachSide((side, from, to) => {
      const key = Math.min(from, to) * corners + Math.max(from, to);
      const other = seen.get(key);
      seen.set(key, side);
      if (other === undefined) return;
      beyond[side] = this.#bend(normals, side, other);
      beyond[other] = this.#bend(normals, other, side);
    });
    return beyond;
  }

  /** How the triangle beyond a side goes on, by its corner across. */
  #bend(normals: Float64Array, side: number, other: number): number {
    const first = side - (side % 3);
    const across = other - (other % 3) + ((other + 2) % 3);
    const [from, to] = [3 * this.#index[side]!, 3 * this.#index[across]!];
    let [rise, square] = [0, 0];
    for (let k = 0; k < 3; k++) {
      const way = this.#points[to + k]! - this.#points[from + k]!;
      rise += way * normals[first + k]!;
      square += way * way;
    }
    if (Math.abs(rise) <= FLAT * Math.sqrt(square)) return SEAM.flat;
    return rise > 0 ? SEAM.rises : SEAM.falls;
  }

  /**
   * Whether the corners of a triangle that lie farthest along a unit vector are the farthest among all that are next to
   * them, too.
   */
  standsOut(triangle: number, x: number, y: number, z: number): boolean {
    const points = this.#points;
    const height = (corner: number): number =>
      x * points[3 * corner]! + y * points[3 * corner + 1]! + z * points[3 * corner + 2]!;
    let most = -Infinity;
    for (let i = 0; i < 3; i++) most = Math.max(most, height(this.#index[3 * triangle + i]!));
    for (let i = 0; i < 3; i++) {
      const corner = this.#same[this.#index[3 * triangle + i]!]!;
      if (height(corner) < most - 1e-6) continue;
      for (let j = this.#from[corner]!; j < this.#from[corner + 1]!; j++) {
        const next = this.#next[j]!;
        if (height(next) - most > STANDS_OUT * this.#apart(corner, next)) return false;
      }
    }
    return true;
  }

  #apart(a: number, b: number): number {
    let sum = 0;
    for (let i = 0; i < 3; i++) sum += (this.#points[3 * a + i]! - this.#points[3 * b + i]!) ** 2;
    return Math.sqrt(sum);
  }
}

function firstInPlace(points: Float64Array): Int32Array {
  const first = new Map<string, number>();
  const same = new Int32Array(points.length / 3);
  for (let i = 0; i < same.length; i++) {
    const place = `${points[3 * i]} ${points[3 * i + 1]} ${points[3 * i + 2]}`;
    const known = first.get(place);
    if (known === undefined) first.set(place, i);
    same[i] = known ?? i;
  }
  return same;
}
