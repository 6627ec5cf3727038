import { MOST_SWOLLEN } from '../tolerances.js';
import type { Masses } from './masses.js';

/**
 * Triangles of constant strain that are stiff in their plane alone, and what a gas does to them that they enclose. Their
 * energy is that of St. Venant and Kirchhoff (plane stress) over (2 + |F|²) / 4, which is 1 as laid: it grows by the square of
 * a stretch, not by its fourth power, and what is stretched is never more than twice as stiff as it was.
 */
export class Skin {
  readonly triangles: Int32Array;
  readonly count: number;
  /** m² of each, as it was laid. */
  readonly areas: Float64Array;
  /** Of its own stiffness each has this share, for parts of a step that are too long for more. */
  readonly soft: Float64Array;
  /**
   * The square of the greatest frequency that each may have by itself, where the skin is 1 N/m stiff and weighs 1 kg/m²,
   * 1/m²: no frequency of all is greater than the greatest of these (Irons and Treharne, 1971).
   */
  readonly squares: Float64Array;
  /** How many times as stiff as laid the most stretched one is, when `look` was there: no more than twice. */
  stiffest = 1;
  /** By how much the square of a length changes at most, then: 0, nothing is strained; 1, anything may lie on anything. */
  crumpled = 0;
  /** N/m, E t / (1 − ν²). */
  stiffness = 0;
  poisson = 0;
  private readonly masses: Masses;
  /** How places in the plane of each follow from two of its sides, 1/m: xx, xy, yy. */
  private readonly inverses: Float64Array;

  constructor(masses: Masses, triangles: Int32Array) {
    this.masses = masses;
    this.triangles = triangles;
    this.count = triangles.length / 3;
    this.areas = new Float64Array(this.count);
    this.soft = new Float64Array(this.count).fill(1);
    this.squares = new Float64Array(this.count);
    this.inverses = new Float64Array(3 * this.count);
    for (let t = 0; t < this.count; t++) this.lay(t);
  }

  private lay(t: number): void {
    const { places } = this.masses;
    const o = 3 * this.triangles[3 * t]!;
    const p = 3 * this.triangles[3 * t + 1]!;
    const q = 3 * this.triangles[3 * t + 2]!;
    let pp = 0;
    let pq = 0;
    let qq = 0;
    for (let k = 0; k < 3; k++) {
      const a = places[p + k]! - places[o + k]!;
      const b = places[q + k]! - places[o + k]!;
      pp += a * a;
      pq += a * b;
      qq += b * b;
    }
    const long = Math.sqrt(pp);
    const along = pq / long;
    const high = Math.sqrt(Math.max(0, qq - along * along));
    this.areas[t] = (long * high) / 2;
    const xx = 1 / long;
    const xy = -along / (long * high);
    const yy = 1 / high;
    this.inverses.set([xx, xy, yy], 3 * t);
    // The sum of the squares of what each corner does to slopes along the two directions of the plane.
    const a = 2 * xx * xx;
    const b = xy * xy + yy * yy + (xy + yy) * (xy + yy);
    const c = 2 * xx * xy + xx * yy;
    const d = (a - b) / 2;
    this.squares[t] = 3 * ((a + b) / 2 + Math.sqrt(d * d + c * c));
  }

  /** m³ inside, counted from one of the points: negative, where triangles look inward. */
  volume(): number {
    const { triangles, masses } = this;
    const { places } = masses;
    const ox = places[0]!;
    const oy = places[1]!;
    const oz = places[2]!;
    let six = 0;
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t]!;
      const b = 3 * triangles[t + 1]!;
      const c = 3 * triangles[t + 2]!;
      const bx = places[b]! - ox;
      const by = places[b + 1]! - oy;
      const bz = places[b + 2]! - oz;
      const cx = places[c]! - ox;
      const cy = places[c + 1]! - oy;
      const cz = places[c + 2]! - oz;
      six +=
        (places[a]! - ox) * (by * cz - bz * cy) +
        (places[a + 1]! - oy) * (bz * cx - bx * cz) +
        (places[a + 2]! - oz) * (bx * cy - by * cx);
    }
    return six / 6;
  }

  /** Looks how far triangles are stretched and pressed together. */
  look(): void {
    const { triangles, inverses, masses } = this;
    const { places } = masses;
    let longest = 1;
    let strained = 0;
    for (let t = 0, n = 0; t < this.count; t++, n += 3) {
      const o = 3 * triangles[n]!;
      const p = 3 * triangles[n + 1]!;
      const q = 3 * triangles[n + 2]!;
      const xx = inverses[n]!;
      const xy = inverses[n + 1]!;
      const yy = inverses[n + 2]!;
      let ff = 0;
      let fg = 0;
      let gg = 0;
      for (let k = 0; k < 3; k++) {
        const a = places[p + k]! - places[o + k]!;
        const b = places[q + k]! - places[o + k]!;
        const f = a * xx;
        const g = a * xy + b * yy;
        ff += f * f;
        fg += f * g;
        gg += g * g;
      }
      const beside = Math.abs(fg);
      longest = Math.max(longest, Math.max(ff, gg) + beside);
      strained = Math.max(strained, Math.abs(ff - 1) + beside, Math.abs(gg - 1) + beside);
    }
    this.stiffest = 2 - 1 / longest;
    this.crumpled = Math.min(1, strained);
  }

  /** What the skin does in `time`, and a gas of `pressure` Pa behind all triangles (negative: before them). */
  push(time: number, pressure: number): void {
    const { triangles, inverses, areas, soft, stiffness, poisson } = this;
    const { places, velocities, inverse } = this.masses;
    for (let t = 0, n = 0; t < this.count; t++, n += 3) {
      const o = triangles[n]!;
      const p = triangles[n + 1]!;
      const q = triangles[n + 2]!;
      const ox = places[3 * o]!;
      const oy = places[3 * o + 1]!;
      const oz = places[3 * o + 2]!;
      const ax = places[3 * p]! - ox;
      const ay = places[3 * p + 1]! - oy;
      const az = places[3 * p + 2]! - oz;
      const bx = places[3 * q]! - ox;
      const by = places[3 * q + 1]! - oy;
      const bz = places[3 * q + 2]! - oz;
      const xx = inverses[n]!;
      const xy = inverses[n + 1]!;
      const yy = inverses[n + 2]!;
      // How x, y, z change along the two directions of the plane.
      const fx = ax * xx;
      const fy = ay * xx;
      const fz = az * xx;
      const gx = ax * xy + bx * yy;
      const gy = ay * xy + by * yy;
      const gz = az * xy + bz * yy;
      const ff = fx * fx + fy * fy + fz * fz;
      const fg = fx * gx + fy * gy + fz * gz;
      const gg = gx * gx + gy * gy + gz * gz;
      const large = 4 / (2 + ff + gg);
      const share = (large * time * stiffness * areas[t]! * soft[t]!) / 2;
      // Stress, times area and time; then along the sides.
      const ef = ff - 1;
      const eg = gg - 1;
      const less = (large / 8) * (ef * ef + eg * eg + 2 * poisson * ef * eg + 2 * (1 - poisson) * fg * fg); // prettier-ignore
      const sff = share * (ef + poisson * eg - less);
      const sgg = share * (eg + poisson * ef - less);
      const sfg = share * (1 - poisson) * fg;
      const pf = sff * xx + sfg * xy;
      const pg = sfg * xx + sgg * xy;
      const qf = sfg * yy;
      const qg = sgg * yy;
      const px = fx * pf + gx * pg;
      const py = fy * pf + gy * pg;
      const pz = fz * pf + gz * pg;
      const qx = fx * qf + gx * qg;
      const qy = fy * qf + gy * qg;
      const qz = fz * qf + gz * qg;
      // A gas does not tear at what is stretched beyond all measure, by which it would only be stretched more.
      const sixth = (time * pressure) / (6 * Math.max(1, (ff + gg) / MOST_SWOLLEN));
      const nx = sixth * (ay * bz - az * by);
      const ny = sixth * (az * bx - ax * bz);
      const nz = sixth * (ax * by - ay * bx);
      const wo = inverse[o]!;
      const wp = inverse[p]!;
      const wq = inverse[q]!;
      velocities[3 * o]! += wo * (nx + px + qx);
      velocities[3 * o + 1]! += wo * (ny + py + qy);
      velocities[3 * o + 2]! += wo * (nz + pz + qz);
      velocities[3 * p]! += wp * (nx - px);
      velocities[3 * p + 1]! += wp * (ny - py);
      velocities[3 * p + 2]! += wp * (nz - pz);
      velocities[3 * q]! += wq * (nx - qx);
      velocities[3 * q + 1]! += wq * (ny - qy);
      velocities[3 * q + 2]! += wq * (nz - qz);
    }
  }
}
