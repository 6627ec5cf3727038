import type { Masses } from './masses.js';

/** Numbers of one coordinate of a cell: how it changes along x, y, z, and the hourglasses yz, zx, xy, xyz. */
const MODES = 7;

/** Box cells of a lattice as sums over their corners (a Hadamard transform there and back). */
export class CellModes {
  /** Those of x, of y and of z of the cell that was read; then, what it is pushed by in each. */
  readonly modes = new Float64Array(3 * MODES);
  private readonly masses: Masses;
  private readonly corners: Int32Array;
  private readonly middles: Float64Array;

  /** Eight corners for each cell, x going fastest, then y; and where in it each is looked at, from −1 to 1. */
  constructor(masses: Masses, corners: Int32Array, middles: Float64Array) {
    this.masses = masses;
    this.corners = corners;
    this.middles = middles;
  }

  /** Sums over the corners of a cell, for each of its modes. */
  read(cell: number): void {
    const { corners, modes } = this;
    const { places } = this.masses;
    const c = 8 * cell;
    const c0 = 3 * corners[c]!;
    const c1 = 3 * corners[c + 1]!;
    const c2 = 3 * corners[c + 2]!;
    const c3 = 3 * corners[c + 3]!;
    const c4 = 3 * corners[c + 4]!;
    const c5 = 3 * corners[c + 5]!;
    const c6 = 3 * corners[c + 6]!;
    const c7 = 3 * corners[c + 7]!;
    for (let k = 0, m = 0; k < 3; k++, m += MODES) {
      const p0 = places[c0 + k]!;
      const p1 = places[c1 + k]!;
      const p2 = places[c2 + k]!;
      const p3 = places[c3 + k]!;
      const p4 = places[c4 + k]!;
      const p5 = places[c5 + k]!;
      const p6 = places[c6 + k]!;
      const p7 = places[c7 + k]!;
      const s01 = p0 + p1;
      const d01 = p1 - p0;
      const s23 = p2 + p3;
      const d23 = p3 - p2;
      const s45 = p4 + p5;
      const d45 = p5 - p4;
      const s67 = p6 + p7;
      const d67 = p7 - p6;
      const x0 = d01 + d23;
      const x1 = d45 + d67;
      const y0 = s23 - s01;
      const y1 = s67 - s45;
      const xy0 = d23 - d01;
      const xy1 = d67 - d45;
      modes[m] = x0 + x1;
      modes[m + 1] = y0 + y1;
      modes[m + 2] = s45 + s67 - s01 - s23;
      modes[m + 3] = y1 - y0;
      modes[m + 4] = x1 - x0;
      modes[m + 5] = xy0 + xy1;
      modes[m + 6] = xy1 - xy0;
    }
    if (this.isAside(cell)) this.goAside(cell);
  }

  private isAside(cell: number): boolean {
    const { middles } = this;
    return middles[3 * cell] !== 0 || middles[3 * cell + 1] !== 0 || middles[3 * cell + 2] !== 0;
  }

  /** From the middle of a cell to where it is looked at: the same polynomial about another point. */
  private goAside(cell: number): void {
    const { modes, middles } = this;
    const x = middles[3 * cell]!;
    const y = middles[3 * cell + 1]!;
    const z = middles[3 * cell + 2]!;
    for (let m = 0; m < 3 * MODES; m += MODES) {
      const yz = modes[m + 3]!;
      const zx = modes[m + 4]!;
      const xy = modes[m + 5]!;
      const xyz = modes[m + 6]!;
      modes[m]! += y * xy + z * zx + y * z * xyz;
      modes[m + 1]! += x * xy + z * yz + z * x * xyz;
      modes[m + 2]! += x * zx + y * yz + x * y * xyz;
      modes[m + 3] = yz + x * xyz;
      modes[m + 4] = zx + y * xyz;
      modes[m + 5] = xy + z * xyz;
    }
  }

  /** The way back, for slopes: what each mode there was made of has its share of what that is pushed by. */
  private comeBack(cell: number): void {
    const { modes, middles } = this;
    const x = middles[3 * cell]!;
    const y = middles[3 * cell + 1]!;
    const z = middles[3 * cell + 2]!;
    for (let m = 0; m < 3 * MODES; m += MODES) {
      const gx = modes[m]!;
      const gy = modes[m + 1]!;
      const gz = modes[m + 2]!;
      const yz = modes[m + 3]!;
      const zx = modes[m + 4]!;
      const xy = modes[m + 5]!;
      modes[m + 3] = yz + z * gy + y * gz;
      modes[m + 4] = zx + z * gx + x * gz;
      modes[m + 5] = xy + y * gx + x * gy;
      modes[m + 6]! += x * yz + y * zx + z * xy + y * z * gx + z * x * gy + x * y * gz;
    }
  }

  /** Pushes the corners of a cell against the slopes of its energy by each of its modes. */
  write(cell: number, time: number): void {
    if (this.isAside(cell)) this.comeBack(cell);
    const { corners, modes } = this;
    const { velocities, inverse } = this.masses;
    const c = 8 * cell;
    const c0 = corners[c]!;
    const c1 = corners[c + 1]!;
    const c2 = corners[c + 2]!;
    const c3 = corners[c + 3]!;
    const c4 = corners[c + 4]!;
    const c5 = corners[c + 5]!;
    const c6 = corners[c + 6]!;
    const c7 = corners[c + 7]!;
    const t0 = time * inverse[c0]!;
    const t1 = time * inverse[c1]!;
    const t2 = time * inverse[c2]!;
    const t3 = time * inverse[c3]!;
    const t4 = time * inverse[c4]!;
    const t5 = time * inverse[c5]!;
    const t6 = time * inverse[c6]!;
    const t7 = time * inverse[c7]!;
    for (let k = 0, m = 0; k < 3; k++, m += MODES) {
      const x = modes[m]!;
      const y = modes[m + 1]!;
      const z = modes[m + 2]!;
      const yz = modes[m + 3]!;
      const zx = modes[m + 4]!;
      const xy = modes[m + 5]!;
      const xyz = modes[m + 6]!;
      const x0 = x - zx;
      const x1 = x + zx;
      const y0 = y - yz;
      const y1 = y + yz;
      const xy0 = xy - xyz;
      const xy1 = xy + xyz;
      const a0 = -z - y0;
      const a1 = y0 - z;
      const a2 = z - y1;
      const a3 = z + y1;
      const b0 = x0 - xy0;
      const b1 = x0 + xy0;
      const b2 = x1 - xy1;
      const b3 = x1 + xy1;
      velocities[3 * c0 + k]! -= t0 * (a0 - b0);
      velocities[3 * c1 + k]! -= t1 * (a0 + b0);
      velocities[3 * c2 + k]! -= t2 * (a1 - b1);
      velocities[3 * c3 + k]! -= t3 * (a1 + b1);
      velocities[3 * c4 + k]! -= t4 * (a2 - b2);
      velocities[3 * c5 + k]! -= t5 * (a2 + b2);
      velocities[3 * c6 + k]! -= t6 * (a3 - b3);
      velocities[3 * c7 + k]! -= t7 * (a3 + b3);
    }
  }
}
