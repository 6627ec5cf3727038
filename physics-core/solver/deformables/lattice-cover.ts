// Which of the cells of a lattice a closed surface covers, and how much of each: by rays along the three axes.

/** A box, and into how many equal cells it is divided: x, y, z of each, metres. */
export interface Grid {
  readonly low: readonly number[];
  readonly size: readonly number[];
  readonly counts: readonly number[];
}

/** What of each cell lies inside a surface; x goes fastest. */
export interface Cover {
  /** How much of it. */
  readonly shares: Float64Array;
  /** Where the middle of that is: x, y, z, each from −1 to 1 in its cell. */
  readonly middles: Float64Array;
  /** The mean square of how far it is around there along each axis, in that of a whole cell (which is 1/3). */
  readonly spreads: Float64Array;
}

/** By `samples` points along each side of a cell. */
export function coverOf(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  grid: Grid,
  samples: number,
): Cover {
  const { counts } = grid;
  const fine = counts.map((n) => n * samples);
  const votes = new Int8Array(fine[0]! * fine[1]! * fine[2]!);
  for (let axis = 0; axis < 3; axis++)
    new Rays(grid, samples, axis).through(points, triangles).vote(votes);
  const count = counts[0]! * counts[1]! * counts[2]!;
  const shares = new Float64Array(count);
  const middles = new Float64Array(3 * count);
  const spreads = new Float64Array(3 * count);
  for (let i = 0; i < votes.length; i++) {
    if (votes[i]! <= 0) continue;
    let cell = 0;
    for (let k = 2, at = i, stride = votes.length; k >= 0; k--) {
      stride /= fine[k]!;
      cell = cell * counts[k]! + Math.floor(Math.floor(at / stride) / samples);
      at %= stride;
    }
    shares[cell]! += 1;
    for (let k = 0, at = i; k < 3; k++) {
      const within = (2 * ((at % fine[k]!) % samples) + 1) / samples - 1;
      middles[3 * cell + k]! += within;
      spreads[3 * cell + k]! += within * within;
      at = Math.floor(at / fine[k]!);
    }
  }
  for (let cell = 0; cell < count; cell++) finish({ shares, middles, spreads }, cell, samples);
  return { shares, middles, spreads };
}

/** Makes means of sums over samples, each of which stands for the little box around it. */
function finish({ shares, middles, spreads }: Cover, cell: number, samples: number): void {
  const within = shares[cell]!;
  const all = samples * samples * samples;
  shares[cell] = within / all;
  for (let j = 3 * cell; j < 3 * cell + 3; j++) {
    const middle = within > 0 && within < all ? middles[j]! / within : 0;
    const around = within > 0 ? spreads[j]! / within - middle * middle : 0;
    middles[j] = middle;
    spreads[j] = within < all ? 3 * around + 1 / (samples * samples) : 1;
  }
}

/** How many rays go through the boxes around triangles, at one for each cell, about. */
export function raysOf(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  { size }: Grid,
): number {
  let rays = 0;
  for (let t = 0; t + 2 < triangles.length; t += 3)
    for (let k = 0; k < 3; k++) {
      const l = (k + 1) % 3;
      rays +=
        1 +
        (extent(points, triangles, t, k) / size[k]!) * (extent(points, triangles, t, l) / size[l]!);
    }
  return rays;
}

function extent(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  t: number,
  k: number,
): number {
  const a = points[3 * triangles[t]! + k]!;
  const b = points[3 * triangles[t + 1]! + k]!;
  const c = points[3 * triangles[t + 2]! + k]!;
  return Math.max(a, b, c) - Math.min(a, b, c);
}

/** Rays along one axis (w), one for each sample across it (u, v). */
class Rays {
  private readonly axes: readonly number[];
  private readonly low: readonly number[];
  private readonly apart: readonly number[];
  private readonly fine: readonly number[];
  /** How often the surface is crossed just before each sample of each ray, and how often outward less inward. */
  private readonly crossings: Uint8Array;
  private readonly windings: Int32Array;
  /** Of a triangle: u, v, w of its corners. */
  private readonly corners = new Float64Array(9);

  constructor({ low, size, counts }: Grid, samples: number, axis: number) {
    this.axes = [(axis + 1) % 3, (axis + 2) % 3, axis];
    this.low = this.axes.map((k) => low[k]!);
    this.apart = this.axes.map((k) => size[k]! / samples);
    this.fine = this.axes.map((k) => counts[k]! * samples);
    const all = this.fine[0]! * this.fine[1]! * (this.fine[2]! + 1);
    this.crossings = new Uint8Array(all);
    this.windings = new Int32Array(all);
  }

  through(points: ArrayLike<number>, triangles: ArrayLike<number>): this {
    for (let t = 0; t + 2 < triangles.length; t += 3) {
      for (let c = 0; c < 3; c++)
        for (let k = 0; k < 3; k++)
          this.corners[3 * c + k] = points[3 * triangles[t + c]! + this.axes[k]!]!;
      this.cross();
    }
    return this;
  }

  /** Number of the first sample that does not lie before a place along u (0), v (1) or w (2). */
  private first(place: number, k: number): number {
    const at = Math.ceil((place - this.low[k]!) / this.apart[k]! - 0.5);
    return Math.min(this.fine[k]!, Math.max(0, at));
  }

  private at(sample: number, k: number): number {
    return this.low[k]! + (sample + 0.5) * this.apart[k]!;
  }

  /** All rays that go through the triangle. One through a side that two triangles share goes through one of them. */
  private cross(): void {
    const p = this.corners;
    const end = this.first(Math.max(p[1]!, p[4]!, p[7]!), 1);
    for (let j = this.first(Math.min(p[1]!, p[4]!, p[7]!), 1); j < end; j++) {
      const v = this.at(j, 1);
      let from = Infinity;
      let to = -Infinity;
      for (let c = 0; c < 3; c++) {
        const d = c === 2 ? 0 : c + 1;
        if (p[3 * c + 1]! > v === p[3 * d + 1]! > v) continue;
        const u = this.meets(c, d, v);
        from = Math.min(from, u);
        to = Math.max(to, u);
      }
      if (from < to) this.crossRow(j, v, this.first(from, 0), this.first(to, 0));
    }
  }

  /** Where a side is at `v`: taken from its lower end on, so that both triangles beside it come to the same bits. */
  private meets(c: number, d: number, v: number): number {
    const p = this.corners;
    const a = p[3 * c + 1]! < p[3 * d + 1]! ? c : d;
    const b = c + d - a;
    const share = (v - p[3 * a + 1]!) / (p[3 * b + 1]! - p[3 * a + 1]!);
    return p[3 * a]! + share * (p[3 * b]! - p[3 * a]!);
  }

  private crossRow(j: number, v: number, from: number, to: number): void {
    const p = this.corners;
    const bu = p[3]! - p[0]!;
    const bv = p[4]! - p[1]!;
    const bw = p[5]! - p[2]!;
    const cu = p[6]! - p[0]!;
    const cv = p[7]! - p[1]!;
    const cw = p[8]! - p[2]!;
    const nw = bu * cv - bv * cu;
    if (nw === 0) return;
    const slopeU = (bv * cw - bw * cv) / nw;
    const slopeV = (bw * cu - bu * cw) / nw;
    const lowest = Math.min(p[2]!, p[5]!, p[8]!);
    const highest = Math.max(p[2]!, p[5]!, p[8]!);
    for (let i = from; i < to; i++) {
      const w = p[2]! - (this.at(i, 0) - p[0]!) * slopeU - (v - p[1]!) * slopeV;
      const k = this.first(Math.min(highest, Math.max(lowest, w)), 2);
      const n = (j * this.fine[0]! + i) * (this.fine[2]! + 1) + k;
      this.crossings[n]! ^= 1;
      this.windings[n]! += nw > 0 ? 1 : -1;
    }
  }

  /**
   * What rays say of each sample: inside or not. A ray that leaves the surface as often as it enters it knows by how often it
   * is inside, and so unites what overlaps; where orientations are mixed it counts crossings; where those are odd, the surface
   * is open, and the ray says nothing.
   */
  vote(votes: Int8Array): void {
    const { axes, fine, crossings, windings } = this;
    const nu = fine[0]!;
    const nv = fine[1]!;
    const nw = fine[2]!;
    const strides = [0, 0, 0];
    const along = [0, 0, 0];
    axes.forEach((axis, k) => (along[axis] = fine[k]!));
    const steps = [1, along[0]!, along[0]! * along[1]!];
    axes.forEach((axis, k) => (strides[k] = steps[axis]!));
    for (let j = 0; j < nv; j++)
      for (let i = 0; i < nu; i++) {
        const n = (j * nu + i) * (nw + 1);
        let odd = 0;
        let turns = 0;
        for (let k = 0; k <= nw; k++) {
          odd ^= crossings[n + k]!;
          turns += windings[n + k]!;
        }
        if (odd) continue;
        const winds = turns === 0;
        for (let k = 0, within = 0, winding = 0; k < nw; k++) {
          within ^= crossings[n + k]!;
          winding += windings[n + k]!;
          const inside = winds ? winding !== 0 : within === 1;
          votes[i * strides[0]! + j * strides[1]! + k * strides[2]!]! += inside ? 1 : -1;
        }
      }
  }
}
