import { dot3 } from '../../base/flat-math.js';

/** Of a tetrahedron's four faces, the corners, and the corner across. */
const FACES = [
  [0, 1, 2, 3],
  [0, 2, 3, 1],
  [0, 3, 1, 2],
  [1, 3, 2, 0],
] as const;

/** A volume below this share of the cube of its edges is flat. */
const FLAT = 1e-12;

/**
 * Up to four points around what lies nearest to the origin (Ericson 2004, 5.1). Each is a difference of two others, which
 * go along.
 */
export class Simplex {
  count = 0;
  /** The differences, and the points that they are of. */
  readonly w = new Float64Array(12);
  readonly a = new Float64Array(12);
  readonly b = new Float64Array(12);
  /** Of the nearest point: the share of each, and where it lies. */
  readonly share = new Float64Array(4);
  readonly nearest = new Float64Array(3);
  readonly #edges = new Float64Array(9);
  readonly #best = new Float64Array(4);

  /** Keeps what is needed for the nearest point. False: the origin is inside. */
  reduce(): boolean {
    this.share.fill(0);
    if (this.count === 1) this.share[0] = 1;
    else if (this.count === 2) this.#segment(0, 1);
    else if (this.count === 3) this.#triangle(0, 1, 2);
    else if (!this.#tetrahedron()) return false;
    this.#drop();
    return true;
  }

  #drop(): void {
    let left = 0;
    this.nearest.fill(0);
    for (let i = 0; i < this.count; i++) {
      const share = this.share[i]!;
      if (share <= 0) continue;
      for (let k = 0; k < 3; k++) {
        this.w[3 * left + k] = this.w[3 * i + k]!;
        this.a[3 * left + k] = this.a[3 * i + k]!;
        this.b[3 * left + k] = this.b[3 * i + k]!;
        this.nearest[k]! += share * this.w[3 * i + k]!;
      }
      this.share[left++] = share;
    }
    this.count = left;
  }

  #distance(): number {
    let sum = 0;
    for (let k = 0; k < 3; k++) {
      let value = 0;
      for (let i = 0; i < this.count; i++) value += this.share[i]! * this.w[3 * i + k]!;
      sum += value * value;
    }
    return sum;
  }

  #edge(to: number, i: number, j: number): void {
    for (let k = 0; k < 3; k++) this.#edges[to + k] = this.w[3 * j + k]! - this.w[3 * i + k]!;
  }

  #segment(i: number, j: number): void {
    const edges = this.#edges;
    this.#edge(0, i, j);
    const size = dot3(edges, 0, edges, 0);
    const along = -dot3(edges, 0, this.w, 3 * i);
    const t = size > 0 ? Math.min(1, Math.max(0, along / size)) : 0;
    this.share[i] = 1 - t;
    this.share[j] = t;
  }

  #triangle(i: number, j: number, k: number): void {
    const { w, share } = this;
    const e = this.#edges;
    this.#edge(0, i, j);
    this.#edge(3, i, k);
    const d1 = -dot3(e, 0, w, 3 * i);
    const d2 = -dot3(e, 3, w, 3 * i);
    if (d1 <= 0 && d2 <= 0) return void (share[i] = 1);
    const d3 = -dot3(e, 0, w, 3 * j);
    const d4 = -dot3(e, 3, w, 3 * j);
    if (d3 >= 0 && d4 <= d3) return void (share[j] = 1);
    const vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return this.#segment(i, j);
    const d5 = -dot3(e, 0, w, 3 * k);
    const d6 = -dot3(e, 3, w, 3 * k);
    if (d6 >= 0 && d5 <= d6) return void (share[k] = 1);
    const vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return this.#segment(i, k);
    const va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return this.#segment(j, k);
    const sum = va + vb + vc;
    share[i] = va / sum;
    share[j] = vb / sum;
    share[k] = vc / sum;
  }

  #tetrahedron(): boolean {
    let least = Infinity;
    for (const [i, j, k, across] of FACES) {
      if (!this.#outside(i, j, k, across)) continue;
      this.share.fill(0);
      this.#triangle(i, j, k);
      const distance = this.#distance();
      if (distance < least) {
        least = distance;
        this.#best.set(this.share);
      }
    }
    if (least === Infinity) return false;
    this.share.set(this.#best);
    return true;
  }

  /** Whether the origin lies on the other side of a face than the fourth corner; so it does of what is flat. */
  #outside(i: number, j: number, k: number, across: number): boolean {
    const e = this.#edges;
    this.#edge(0, i, j);
    this.#edge(3, i, k);
    this.#edge(6, i, across);
    const nx = e[1]! * e[5]! - e[2]! * e[4]!;
    const ny = e[2]! * e[3]! - e[0]! * e[5]!;
    const nz = e[0]! * e[4]! - e[1]! * e[3]!;
    const { w } = this;
    const origin = -(nx * w[3 * i]! + ny * w[3 * i + 1]! + nz * w[3 * i + 2]!);
    const corner = nx * e[6]! + ny * e[7]! + nz * e[8]!;
    const size = dot3(e, 0, e, 0) * dot3(e, 3, e, 3) * dot3(e, 6, e, 6);
    return corner * corner <= FLAT * FLAT * size || origin * corner < 0;
  }
}
