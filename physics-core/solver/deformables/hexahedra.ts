import type { Masses } from './masses.js';

// Box cells that bend as beams do, and are stiff by the mean of their deformation alone otherwise: one point of integration
// (Flanagan and Belytschko, 1981), a stable neo-Hookean solid there (Smith, de Goes and Kim, 2018), and for the four ways to
// deform in which that mean says nothing, the "hourglasses", the energy of a box with incompatible modes (Wilson, 1973),
// condensed: a cell is bent as if its sides could curve. All energies are polynomials of the places and the same however
// the body is turned, so that forces add up to nothing, turn nothing, and are none in what is only turned.

/** Numbers of one coordinate of a cell: how it changes along x, y, z, and the hourglasses yz, zx, xy, xyz. */
const MODES = 7;

export class Hexahedra {
  readonly count: number;
  /** How much of each cell is there. */
  readonly cover: Float64Array;
  /** Of all stiffness, this share is left, for parts of a step that are too long for more. */
  soft = 1;
  /** Shear modulus, and what resists a change of volume (Lamé's first parameter and µ), each times a cell's volume, J. */
  private shear = 0;
  private bulk = 0;
  private poisson = 0;
  /** What hourglasses cost whichever way they point, J/m²: that of xyz for itself. */
  private plain = 0;
  private plainest = 0;
  /** Of those that bend, of those that twist, J; of the last one along each axis, J/m². */
  private bend = 0;
  private twist = 0;
  private readonly last = new Float64Array(3);
  /** The greatest stiffness of an hourglass, and that of a change of volume, N/m of a mass of 1 kg (1/s²) at 1 kg a cell. */
  private hourglass = 0;
  private readonly corners: Int32Array;
  private readonly masses: Masses;
  private readonly volume: number;
  /** 1 / (4 sides): what a sum over corners becomes a slope by. */
  private readonly qx: number;
  private readonly qy: number;
  private readonly qz: number;
  private readonly modes = new Float64Array(3 * MODES);

  constructor(masses: Masses, corners: Int32Array, cover: Float64Array, size: readonly number[]) {
    this.masses = masses;
    this.corners = corners;
    this.cover = cover;
    this.count = cover.length;
    this.volume = size[0]! * size[1]! * size[2]!;
    this.qx = 1 / (4 * size[0]!);
    this.qy = 1 / (4 * size[1]!);
    this.qz = 1 / (4 * size[2]!);
  }

  /** Pa, and without a unit. */
  stiffen(youngsModulus: number, poissonsRatio: number): void {
    const { volume, qx, qy, qz } = this;
    const mu = youngsModulus / (2 * (1 + poissonsRatio));
    this.poisson = poissonsRatio;
    this.shear = volume * mu;
    this.bulk = (volume * mu) / (1 - 2 * poissonsRatio);
    this.bend = (volume * youngsModulus) / (3 * (1 - poissonsRatio * poissonsRatio));
    this.twist = (volume * mu) / 3;
    const xx = qx * qx;
    const yy = qy * qy;
    const zz = qz * qz;
    this.last[0] = (volume / 9) * (youngsModulus * xx + mu * (yy + zz));
    this.last[1] = (volume / 9) * (youngsModulus * yy + mu * (zz + xx));
    this.last[2] = (volume / 9) * (youngsModulus * zz + mu * (xx + yy));
    this.share(xx, yy, zz);
  }

  /** What each hourglass costs at least goes by its length, which is there even when the cell is crushed flat. */
  private share(xx: number, yy: number, zz: number): void {
    const { bend, twist, poisson, last } = this;
    // Of a matrix whose roots are positive, the least is no less than this: of two by two, and of three by three.
    const pair = (a: number, b: number): number =>
      (bend * (1 - poisson * poisson) * a * b) / (a + b);
    // (the latter's determinant is 4 xx yy zz).
    const trace = 2 * (xx + yy + zz);
    const three = (16 * twist * xx * yy * zz) / (trace * trace);
    this.plain = Math.min(pair(xx, zz), pair(xx, yy), pair(yy, zz), three);
    this.plainest = Math.min(last[0]!, last[1]!, last[2]!);
    this.hourglass = Math.max(
      bend * (1 + Math.abs(poisson)) * Math.max(xx, yy, zz),
      twist * (trace - Math.min(xx, yy, zz)),
      last[0]!,
      last[1]!,
      last[2]!,
    );
  }

  /** Of the square of the greatest frequency, the share that an hourglass may have, for cells of `mass` kg. */
  hourglassShare(square: number, mass: number): number {
    return square > 0 && mass > 0 ? Math.min(1, (64 * this.hourglass) / (mass * square)) : 1;
  }

  /** Sums over the corners of a cell, for each of its modes. */
  private read(cell: number): void {
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
  }

  /** Pushes the corners of a cell against the slopes of its energy by each of its modes. */
  private write(cell: number, time: number): void {
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

  /**
   * What forces do in `time`. No cell is to be more than `most` times as stiff as at rest (by squares of frequencies): one
   * that a blow has made stiffer than this part of a step can follow pushes less.
   */
  push(time: number, most: number, hourglassShare: number): void {
    for (let cell = 0; cell < this.count; cell++) {
      this.read(cell);
      const excess = this.strain(hourglassShare) / most;
      const share = excess > 1 ? 1 / excess : 1;
      this.stress();
      this.write(cell, time * share * this.soft * this.cover[cell]!);
    }
  }

  /** How many times as stiff as at rest the stiffest cell is now, as the square of its frequency is. */
  stiffest(hourglassShare: number): number {
    let most = 1;
    for (let cell = 0; cell < this.count; cell++) {
      this.read(cell);
      most = Math.max(most, this.strain(hourglassShare));
    }
    return most;
  }

  /**
   * How many times as stiff as at rest the cell is that was read. Of waves along one axis all but the change of volume is as
   * stiff as ever; that is by the square of areas (the rank-one convexity of polyconvex energies).
   */
  private strain(hourglassShare: number): number {
    const { modes, qx, qy, qz, shear, bulk } = this;
    const a = modes[0]! * qx;
    const b = modes[1]! * qy;
    const c = modes[2]! * qz;
    const d = modes[7]! * qx;
    const e = modes[8]! * qy;
    const f = modes[9]! * qz;
    const g = modes[14]! * qx;
    const h = modes[15]! * qy;
    const i = modes[16]! * qz;
    const ca = e * i - f * h;
    const cd = h * c - i * b;
    const cg = b * f - c * e;
    const areas = span(ca, f * g - d * i, d * h - e * g, cd, i * a - g * c, g * b - h * a, cg, c * d - f * a, a * e - b * d); // prettier-ignore
    const lengths = span(a, b, c, d, e, f, g, h, i);
    const change = Math.abs(a * ca + d * cd + g * cg - 1) * Math.sqrt(lengths);
    const solid = (shear + bulk * (areas + 0.7 * change)) / (shear + bulk);
    return Math.max(solid, hourglassShare * lengths);
  }

  /** In the place of each mode, how the energy of the cell that was read changes by it. */
  private stress(): void {
    const { modes, qx, qy, qz, shear, bulk, poisson, bend, twist, plain, plainest, last } = this;
    // The mean of the deformation's gradient: how x (a, b, c), y (d, e, f) and z (g, h, i) change along each axis.
    const a = modes[0]! * qx;
    const b = modes[1]! * qy;
    const c = modes[2]! * qz;
    const d = modes[7]! * qx;
    const e = modes[8]! * qy;
    const f = modes[9]! * qz;
    const g = modes[14]! * qx;
    const h = modes[15]! * qy;
    const i = modes[16]! * qz;
    // Hourglasses, as vectors.
    const ux = modes[3]!;
    const uy = modes[10]!;
    const uz = modes[17]!;
    const vx = modes[4]!;
    const vy = modes[11]!;
    const vz = modes[18]!;
    const wx = modes[5]!;
    const wy = modes[12]!;
    const wz = modes[19]!;
    const tx = modes[6]!;
    const ty = modes[13]!;
    const tz = modes[20]!;
    // Along the axes of the cell, which go and stretch with it.
    const u1 = ux * a + uy * d + uz * g;
    const u2 = ux * b + uy * e + uz * h;
    const u3 = ux * c + uy * f + uz * i;
    const v1 = vx * a + vy * d + vz * g;
    const v2 = vx * b + vy * e + vz * h;
    const v3 = vx * c + vy * f + vz * i;
    const w1 = wx * a + wy * d + wz * g;
    const w2 = wx * b + wy * e + wz * h;
    const w3 = wx * c + wy * f + wz * i;
    const t1 = tx * a + ty * d + tz * g;
    const t2 = tx * b + ty * e + tz * h;
    const t3 = tx * c + ty * f + tz * i;
    // Bending: two axes are stretched above and compressed below, and what is between them is free to give way.
    const yx = w1 * qx;
    const yz = u3 * qz;
    const xy = w2 * qy;
    const xz = v3 * qz;
    const zx = v1 * qx;
    const zy = u2 * qy;
    // Twisting.
    const sz = u1 * qy + v2 * qx;
    const sy = u1 * qz + w3 * qx;
    const sx = v2 * qz + w3 * qy;
    const gu1 = twist * (sz * qy + sy * qz) - plain * u1;
    const gu2 = bend * qy * (zy + poisson * zx) - plain * u2;
    const gu3 = bend * qz * (yz + poisson * yx) - plain * u3;
    const gv1 = bend * qx * (zx + poisson * zy) - plain * v1;
    const gv2 = twist * (sz * qx + sx * qz) - plain * v2;
    const gv3 = bend * qz * (xz + poisson * xy) - plain * v3;
    const gw1 = bend * qx * (yx + poisson * yz) - plain * w1;
    const gw2 = bend * qy * (xy + poisson * xz) - plain * w2;
    const gw3 = twist * (sy * qx + sx * qy) - plain * w3;
    const gt1 = (last[0]! - plainest) * t1;
    const gt2 = (last[1]! - plainest) * t2;
    const gt3 = (last[2]! - plainest) * t3;
    modes[3] = plain * ux + gu1 * a + gu2 * b + gu3 * c;
    modes[10] = plain * uy + gu1 * d + gu2 * e + gu3 * f;
    modes[17] = plain * uz + gu1 * g + gu2 * h + gu3 * i;
    modes[4] = plain * vx + gv1 * a + gv2 * b + gv3 * c;
    modes[11] = plain * vy + gv1 * d + gv2 * e + gv3 * f;
    modes[18] = plain * vz + gv1 * g + gv2 * h + gv3 * i;
    modes[5] = plain * wx + gw1 * a + gw2 * b + gw3 * c;
    modes[12] = plain * wy + gw1 * d + gw2 * e + gw3 * f;
    modes[19] = plain * wz + gw1 * g + gw2 * h + gw3 * i;
    modes[6] = plainest * tx + gt1 * a + gt2 * b + gt3 * c;
    modes[13] = plainest * ty + gt1 * d + gt2 * e + gt3 * f;
    modes[20] = plainest * tz + gt1 * g + gt2 * h + gt3 * i;
    // The mean: µ F + (λ' (J − 1) − µ) cof F, and what hourglasses do to the axes that they are measured along.
    const ca = e * i - f * h;
    const cb = f * g - d * i;
    const cc = d * h - e * g;
    const pressure = bulk * (a * ca + b * cb + c * cc - 1) - shear;
    const x1 = shear * a + pressure * ca;
    const x2 = shear * b + pressure * cb;
    const x3 = shear * c + pressure * cc;
    const y1 = shear * d + pressure * (h * c - i * b);
    const y2 = shear * e + pressure * (i * a - g * c);
    const y3 = shear * f + pressure * (g * b - h * a);
    const z1 = shear * g + pressure * (b * f - c * e);
    const z2 = shear * h + pressure * (c * d - f * a);
    const z3 = shear * i + pressure * (a * e - b * d);
    modes[0] = qx * (x1 + gu1 * ux + gv1 * vx + gw1 * wx + gt1 * tx);
    modes[1] = qy * (x2 + gu2 * ux + gv2 * vx + gw2 * wx + gt2 * tx);
    modes[2] = qz * (x3 + gu3 * ux + gv3 * vx + gw3 * wx + gt3 * tx);
    modes[7] = qx * (y1 + gu1 * uy + gv1 * vy + gw1 * wy + gt1 * ty);
    modes[8] = qy * (y2 + gu2 * uy + gv2 * vy + gw2 * wy + gt2 * ty);
    modes[9] = qz * (y3 + gu3 * uy + gv3 * vy + gw3 * wy + gt3 * ty);
    modes[14] = qx * (z1 + gu1 * uz + gv1 * vz + gw1 * wz + gt1 * tz);
    modes[15] = qy * (z2 + gu2 * uz + gv2 * vz + gw2 * wz + gt2 * tz);
    modes[16] = qz * (z3 + gu3 * uz + gv3 * vz + gw3 * wz + gt3 * tz);
  }
}

/** The square by which a matrix lengthens anything at most, or a little more: exact where its axes are kept. */
// prettier-ignore
function span(a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number): number {
  const xy = Math.abs(a * b + d * e + g * h);
  const yz = Math.abs(b * c + e * f + h * i);
  const zx = Math.abs(c * a + f * d + i * g);
  return Math.max(a * a + d * d + g * g + xy + zx, b * b + e * e + h * h + xy + yz, c * c + f * f + i * i + yz + zx);
}
