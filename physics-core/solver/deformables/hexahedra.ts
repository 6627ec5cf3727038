import { CellModes } from './cell-modes.js';
import type { Cells } from './lattice-cells.js';
import type { Masses } from './masses.js';

// Box cells that bend as beams do, and are stiff by the mean of their deformation alone otherwise: one point of integration
// (Flanagan and Belytschko, 1981), a stable neo-Hookean solid there (Smith, de Goes and Kim, 2018), and for the four ways to
// deform in which that mean says nothing, the "hourglasses", the energy of a box with incompatible modes (Wilson, 1973),
// condensed: a cell is bent as if its sides could curve. Where but a part of a cell is covered, the point is the middle of
// that. Energies are the same however the body is turned, so that forces add up to nothing, turn nothing, and are none in
// what is only turned.
//
// Of F, the gradient of the deformation at the point, with I = |F|², J = det F, A = |cof F|²:
//
//     energy / volume = 2/3 µ (I − log (I + 1)) − µ y + λ'/2 y²,   y = (J − 1) / √q,   q = (A + 3) / 6,   λ' = λ + µ/6
//
// At rest it is that of Hooke's law. Smith's has J − 1 for y, which makes what is pressed flat stiffer by the fourth power of
// how wide it is (100 times in what is three times as wide): no part of a step would be short enough. J − 1 over how fast it
// changes is how far it is to a volume as at rest, and the energy grows by the square of that. From any F, also one that is
// crushed or inside out, the way down leads to what is only turned (200 random ones at each of three Poisson's ratios).

export class Hexahedra {
  readonly count: number;
  /** Of all stiffness, this share is left, for parts of a step that are too long for more. */
  soft = 1;
  /** µ and λ', each times a cell's volume, J. */
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
  /** How much of each cell is there, and how far around its middle along each axis, in that of a whole one. */
  private readonly shares: Float64Array;
  private readonly spreads: Float64Array;
  private readonly cells: CellModes;
  private readonly volume: number;
  /** 1 / (4 sides): what a sum over corners becomes a slope by. */
  private readonly qx: number;
  private readonly qy: number;
  private readonly qz: number;
  /** 1/m²: what squares of sums that are hourglasses are compared with squares of slopes by. */
  private readonly scale: number;

  constructor(masses: Masses, { corners, cover, size }: Cells) {
    this.cells = new CellModes(masses, corners, cover.middles);
    this.shares = cover.shares;
    this.spreads = cover.spreads;
    this.count = cover.shares.length;
    this.volume = size[0]! * size[1]! * size[2]!;
    this.qx = 1 / (4 * size[0]!);
    this.qy = 1 / (4 * size[1]!);
    this.qz = 1 / (4 * size[2]!);
    const most = Math.max(this.qx, this.qy, this.qz);
    this.scale = most * most;
  }

  /** Pa, and without a unit. */
  stiffen(youngsModulus: number, poissonsRatio: number): void {
    const { volume, qx, qy, qz } = this;
    const mu = youngsModulus / (2 * (1 + poissonsRatio));
    this.poisson = poissonsRatio;
    this.shear = volume * mu;
    this.bulk = volume * mu * ((2 * poissonsRatio) / (1 - 2 * poissonsRatio) + 1 / 6);
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

  /** What forces do in `time`. */
  push(time: number): void {
    for (let cell = 0; cell < this.count; cell++) {
      this.cells.read(cell);
      this.stress(cell);
      this.cells.write(cell, time * this.soft * this.shares[cell]!);
    }
  }

  /** How many times as stiff as at rest the stiffest cell is now, as the square of its frequency is. */
  stiffest(hourglassShare: number): number {
    let most = 1;
    for (let cell = 0; cell < this.count; cell++) {
      this.cells.read(cell);
      most = Math.max(most, this.stiffer(hourglassShare));
    }
    return most;
  }

  /**
   * How many times as stiff as at rest the cell is that was read, to waves along one axis: up to five times in what is pressed
   * flat and all but incompressible, two in all else. (By random F between −1.5 and 3 it is less by a quarter at worst.)
   */
  private stiffer(hourglassShare: number): number {
    const { qx, qy, qz, shear, bulk } = this;
    const { modes } = this.cells;
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
    const cb = f * g - d * i;
    const cc = d * h - e * g;
    const cd = h * c - i * b;
    const ce = i * a - g * c;
    const cf = g * b - h * a;
    const cg = b * f - c * e;
    const ch = c * d - f * a;
    const ci = a * e - b * d;
    const square = ca * ca + cb * cb + cc * cc + cd * cd + ce * ce + cf * cf + cg * cg + ch * ch + ci * ci; // prettier-ignore
    const r2 = 6 / (square + 3);
    const change = Math.abs(a * ca + b * cb + c * cc - 1) * Math.sqrt(r2);
    const plain = (11 / 6) * shear;
    const solid = plain + bulk * (span(ca, cb, cc, cd, ce, cf, cg, ch, ci) * r2 + change);
    const lengths = a * a + b * b + c * c + d * d + e * e + f * f + g * g + h * h + i * i;
    const hourglass = (span(a, b, c, d, e, f, g, h, i) * 6) / (3 + lengths);
    return Math.max(solid / (plain + bulk), hourglassShare * hourglass);
  }

  /** In the place of each mode, how the energy of the cell that was read changes by it. */
  private stress(cell: number): void {
    const { qx, qy, qz, shear, bulk, poisson, bend, twist, last, scale, spreads } = this;
    const mx = spreads[3 * cell]!;
    const my = spreads[3 * cell + 1]!;
    const mz = spreads[3 * cell + 2]!;
    const least = Math.min(mx, my, mz);
    const plain = least * this.plain;
    const plainest = least * least * this.plainest;
    const { modes } = this.cells;
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
    const yx = my * w1 * qx;
    const yz = my * u3 * qz;
    const xy = mx * w2 * qy;
    const xz = mx * v3 * qz;
    const zx = mz * v1 * qx;
    const zy = mz * u2 * qy;
    // Twisting.
    const sz = mz * (u1 * qy + v2 * qx);
    const sy = my * (u1 * qz + w3 * qx);
    const sx = mx * (v2 * qz + w3 * qy);
    let gu1 = twist * (sz * qy + sy * qz) - plain * u1;
    let gu2 = bend * qy * (zy + poisson * zx) - plain * u2;
    let gu3 = bend * qz * (yz + poisson * yx) - plain * u3;
    let gv1 = bend * qx * (zx + poisson * zy) - plain * v1;
    let gv2 = twist * (sz * qx + sx * qz) - plain * v2;
    let gv3 = bend * qz * (xz + poisson * xy) - plain * v3;
    let gw1 = bend * qx * (yx + poisson * yz) - plain * w1;
    let gw2 = bend * qy * (xy + poisson * xz) - plain * w2;
    let gw3 = twist * (sy * qx + sx * qy) - plain * w3;
    let gt1 = (my * mz * last[0]! - plainest) * t1;
    let gt2 = (mz * mx * last[1]! - plainest) * t2;
    let gt3 = (mx * my * last[2]! - plainest) * t3;
    // That energy goes by the fourth power of what is large: over the square of it, which is 1 at rest.
    const twice = gu1 * u1 + gu2 * u2 + gu3 * u3 + gv1 * v1 + gv2 * v2 + gv3 * v3 + gw1 * w1 + gw2 * w2 + gw3 * w3 + gt1 * t1 + gt2 * t2 + gt3 * t3; // prettier-ignore
    const crooked = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz + wx * wx + wy * wy + wz * wz + tx * tx + ty * ty + tz * tz; // prettier-ignore
    const xx = a * a + d * d + g * g;
    const yy = b * b + e * e + h * h;
    const zz = c * c + f * f + i * i;
    const lengths = xx + yy + zz;
    const large = 6 / (3 + lengths + scale * crooked);
    const lessStretch = (twice * large * large) / 6;
    const lessCrooked = plain - lessStretch * scale;
    const lessLast = plainest - lessStretch * scale;
    gu1 *= large;
    gu2 *= large;
    gu3 *= large;
    gv1 *= large;
    gv2 *= large;
    gv3 *= large;
    gw1 *= large;
    gw2 *= large;
    gw3 *= large;
    gt1 *= large;
    gt2 *= large;
    gt3 *= large;
    modes[3] = lessCrooked * ux + gu1 * a + gu2 * b + gu3 * c;
    modes[10] = lessCrooked * uy + gu1 * d + gu2 * e + gu3 * f;
    modes[17] = lessCrooked * uz + gu1 * g + gu2 * h + gu3 * i;
    modes[4] = lessCrooked * vx + gv1 * a + gv2 * b + gv3 * c;
    modes[11] = lessCrooked * vy + gv1 * d + gv2 * e + gv3 * f;
    modes[18] = lessCrooked * vz + gv1 * g + gv2 * h + gv3 * i;
    modes[5] = lessCrooked * wx + gw1 * a + gw2 * b + gw3 * c;
    modes[12] = lessCrooked * wy + gw1 * d + gw2 * e + gw3 * f;
    modes[19] = lessCrooked * wz + gw1 * g + gw2 * h + gw3 * i;
    modes[6] = lessLast * tx + gt1 * a + gt2 * b + gt3 * c;
    modes[13] = lessLast * ty + gt1 * d + gt2 * e + gt3 * f;
    modes[20] = lessLast * tz + gt1 * g + gt2 * h + gt3 * i;
    // The mean: F, cof F, and what both make of q, which is (tr C F − F C) / 3 with C = Fᵀ F.
    const aa = e * i - f * h;
    const ab = f * g - d * i;
    const ac = d * h - e * g;
    const ad = h * c - i * b;
    const ae = i * a - g * c;
    const af = g * b - h * a;
    const ag = b * f - c * e;
    const ah = c * d - f * a;
    const ai = a * e - b * d;
    const square = aa * aa + ab * ab + ac * ac + ad * ad + ae * ae + af * af + ag * ag + ah * ah + ai * ai; // prettier-ignore
    const r2 = 6 / (square + 3);
    const r = Math.sqrt(r2);
    const y = (a * aa + b * ab + c * ac - 1) * r;
    const pressure = bulk * y - shear;
    const area = pressure * r;
    const spread = (pressure * y * r2) / 6;
    const stretch = (4 / 3) * shear * (1 - 1 / (lengths + 1)) - lessStretch;
    const sx1 = stretch - spread * (yy + zz);
    const sy2 = stretch - spread * (zz + xx);
    const sz3 = stretch - spread * (xx + yy);
    const s12 = spread * (a * b + d * e + g * h);
    const s23 = spread * (b * c + e * f + h * i);
    const s31 = spread * (c * a + f * d + i * g);
    const x1 = sx1 * a + s12 * b + s31 * c + area * aa;
    const x2 = s12 * a + sy2 * b + s23 * c + area * ab;
    const x3 = s31 * a + s23 * b + sz3 * c + area * ac;
    const y1 = sx1 * d + s12 * e + s31 * f + area * ad;
    const y2 = s12 * d + sy2 * e + s23 * f + area * ae;
    const y3 = s31 * d + s23 * e + sz3 * f + area * af;
    const z1 = sx1 * g + s12 * h + s31 * i + area * ag;
    const z2 = s12 * g + sy2 * h + s23 * i + area * ah;
    const z3 = s31 * g + s23 * h + sz3 * i + area * ai;
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
