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
  /** Of a tetrahedron's faces, the nearest so far: its distance, squared, and its shares. */
  #least = Infinity;
  /** Of the tetrahedron: from its first corner to the others, then from the second to the last, the third and the first. */
  readonly #edges = new Float64Array(18);
  readonly #best = new Float64Array(4);

  #clearShares(): void {
    const { share } = this;
    share[0] = share[1] = share[2] = share[3] = 0;
  }

  /** Keeps what is needed for the nearest point. False: the origin is inside. */
  reduce(): boolean {
    this.#clearShares();
    if (this.count === 1) this.share[0] = 1;
    else if (this.count === 2) this.#segment(0, 1);
    else if (this.count === 3) this.#triangle(0, 1, 2);
    else if (!this.#tetrahedron()) return false;
    this.#drop();
    return true;
  }

  #drop(): void {
    const { w, a, b, nearest } = this;
    let left = 0;
    let x = 0;
    let y = 0;
    let z = 0;
    for (let i = 0; i < this.count; i++) {
      const share = this.share[i]!;
      if (share <= 0) continue;
      const to = 3 * left;
      const from = 3 * i;
      if (left < i) {
        copy3(w, from, to);
        copy3(a, from, to);
        copy3(b, from, to);
      }
      x += share * w[to]!;
      y += share * w[to + 1]!;
      z += share * w[to + 2]!;
      this.share[left++] = share;
    }
    this.count = left;
    nearest[0] = x;
    nearest[1] = y;
    nearest[2] = z;
  }

  /** Squared, of what four shares make. */
  #distance(): number {
    const { share, w } = this;
    const a = share[0]!;
    const b = share[1]!;
    const c = share[2]!;
    const d = share[3]!;
    const x = a * w[0]! + b * w[3]! + c * w[6]! + d * w[9]!;
    const y = a * w[1]! + b * w[4]! + c * w[7]! + d * w[10]!;
    const z = a * w[2]! + b * w[5]! + c * w[8]! + d * w[11]!;
    return x * x + y * y + z * z;
  }

  #segment(i: number, j: number): void {
    const { w, share } = this;
    const x = w[3 * i]!;
    const y = w[3 * i + 1]!;
    const z = w[3 * i + 2]!;
    const ex = w[3 * j]! - x;
    const ey = w[3 * j + 1]! - y;
    const ez = w[3 * j + 2]! - z;
    const size = ex * ex + ey * ey + ez * ez;
    const along = -(ex * x + ey * y + ez * z);
    const t = size > 0 ? Math.min(1, Math.max(0, along / size)) : 0;
    share[i] = 1 - t;
    share[j] = t;
  }

  #triangle(i: number, j: number, k: number): void {
    const { w, share } = this;
    const ix = w[3 * i]!;
    const iy = w[3 * i + 1]!;
    const iz = w[3 * i + 2]!;
    const jx = w[3 * j]!;
    const jy = w[3 * j + 1]!;
    const jz = w[3 * j + 2]!;
    const kx = w[3 * k]!;
    const ky = w[3 * k + 1]!;
    const kz = w[3 * k + 2]!;
    const ex = jx - ix;
    const ey = jy - iy;
    const ez = jz - iz;
    const fx = kx - ix;
    const fy = ky - iy;
    const fz = kz - iz;
    const d1 = -(ex * ix + ey * iy + ez * iz);
    const d2 = -(fx * ix + fy * iy + fz * iz);
    if (d1 <= 0 && d2 <= 0) return void (share[i] = 1);
    const d3 = -(ex * jx + ey * jy + ez * jz);
    const d4 = -(fx * jx + fy * jy + fz * jz);
    if (d3 >= 0 && d4 <= d3) return void (share[j] = 1);
    const vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return this.#segment(i, j);
    const d5 = -(ex * kx + ey * ky + ez * kz);
    const d6 = -(fx * kx + fy * ky + fz * kz);
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

  /** The nearest of those faces that the origin lies beyond: their edges are worked out once for all that share them. */
  #tetrahedron(): boolean {
    for (let i = 1; i < 4; i++) this.#writeEdge(3 * i - 3, i, 0);
    this.#writeEdge(9, 3, 1);
    this.#writeEdge(12, 2, 1);
    this.#writeEdge(15, 0, 1);
    this.#least = Infinity;
    if (this.#isOutside(0, 0, 3, 6)) this.#tryFace(0, 1, 2);
    if (this.#isOutside(0, 3, 6, 0)) this.#tryFace(0, 2, 3);
    if (this.#isOutside(0, 6, 0, 3)) this.#tryFace(0, 3, 1);
    if (this.#isOutside(3, 9, 12, 15)) this.#tryFace(1, 3, 2);
    if (this.#least === Infinity) return false;
    copy4(this.#best, this.share);
    return true;
  }

  #writeEdge(at: number, to: number, from: number): void {
    const { w } = this;
    for (let k = 0; k < 3; k++) this.#edges[at + k] = w[3 * to + k]! - w[3 * from + k]!;
  }

  /**
   * Whether the origin lies on the other side of a face than the fourth corner; so it does of what is flat. Where a corner of
   * the face begins, two edges from there, and the one to the fourth: as numbers that are no integers they would be boxed.
   */
  #isOutside(corner: number, e: number, f: number, g: number): boolean {
    const { w } = this;
    const edges = this.#edges;
    const ex = edges[e]!;
    const ey = edges[e + 1]!;
    const ez = edges[e + 2]!;
    const fx = edges[f]!;
    const fy = edges[f + 1]!;
    const fz = edges[f + 2]!;
    const gx = edges[g]!;
    const gy = edges[g + 1]!;
    const gz = edges[g + 2]!;
    const nx = ey * fz - ez * fy;
    const ny = ez * fx - ex * fz;
    const nz = ex * fy - ey * fx;
    const origin = -(nx * w[corner]! + ny * w[corner + 1]! + nz * w[corner + 2]!);
    const fourth = nx * gx + ny * gy + nz * gz;
    if (origin * fourth < 0) return true;
    const size =
      (ex * ex + ey * ey + ez * ez) * (fx * fx + fy * fy + fz * fz) * (gx * gx + gy * gy + gz * gz);
    return fourth * fourth <= FLAT * FLAT * size;
  }

  #tryFace(i: number, j: number, k: number): void {
    this.#clearShares();
    this.#triangle(i, j, k);
    const distance = this.#distance();
    if (!(distance < this.#least)) return;
    this.#least = distance;
    copy4(this.share, this.#best);
  }
}

/** `set` and `copyWithin` of arrays take longer than a round of the search. */
function copy3(all: Float64Array, from: number, to: number): void {
  all[to] = all[from]!;
  all[to + 1] = all[from + 1]!;
  all[to + 2] = all[from + 2]!;
}

function copy4(from: Float64Array, to: Float64Array): void {
  to[0] = from[0]!;
  to[1] = from[1]!;
  to[2] = from[2]!;
  to[3] = from[3]!;
}
