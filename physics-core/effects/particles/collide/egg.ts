import type { Vec3 } from '../../../fields/types.js';
import { Convex, PARALLEL, TOUCH, type Flat } from './solid.js';

/** So near to the middle, as a share of its half axis, it is looked at from beside it: else no side would be nearer. */
const BESIDE = 1e-9;

const MOST_STEPS = 60;

/** An ellipsoid with its axes along those of its frame. */
export class EggSolid extends Convex {
  readonly box: Flat;
  /** Its half axes, and the least of them. */
  readonly #half: Flat;
  readonly #least: number;

  constructor(half: Vec3) {
    super();
    this.#half = Float64Array.from(half);
    this.#least = Math.min(...half);
    this.box = Float64Array.from([...half.map((value) => -value), ...half]);
  }

  /** By one of the same form in which it has room with the radius around it. */
  protected cut(way: Flat, out: Flat): boolean {
    const radius = way[6]!;
    const most = way[7]!;
    const half = this.#half;
    const wider = 1 + radius / this.#least;
    let a = 0;
    let b = 0;
    let c = -1;
    for (let k = 0; k < 3; k++) {
      const p = way[k]! / (half[k]! * wider);
      const d = way[3 + k]! / (half[k]! * wider);
      a += d * d;
      b += p * d;
      c += p * p;
    }
    out[4] = radius <= TOUCH ? 1 : 0;
    out[0] = -Infinity;
    // The touch of what does not move.
    if (a <= PARALLEL ** 2) return c <= TOUCH;
    const inner = b * b - a * c;
    if (!(inner >= 0)) return false;
    const sum = -(b + (b < 0 ? -Math.sqrt(inner) : Math.sqrt(inner)));
    const one = sum / a;
    const other = sum === 0 ? one : c / sum;
    const enter = Math.min(one, other);
    const exit = Math.max(one, other);
    if (!(enter <= most && exit >= 0)) return false;
    out[0] = enter;
    let size = 0;
    for (let k = 0; k < 3; k++) {
      out[1 + k] = (way[k]! + way[3 + k]! * enter) / (half[k]! * half[k]!);
      size += out[1 + k]! * out[1 + k]!;
    }
    for (let k = 1; k < 4; k++) out[k]! /= Math.sqrt(size);
    return true;
  }

  /**
   * The nearest point q of the surface has x - q along its normal: q = a² x / (a² + far), for the one `far` that puts it
   * there. What has to be 0 is convex in it, so Newton's steps come from below and never leap over.
   */
  gap(at: Flat, out: Flat): void {
    const half = this.#half;
    for (let k = 0; k < 3; k++) out[k] = at[k]!;
    let inside = -1;
    for (let k = 0; k < 3; k++) inside += (out[k]! / half[k]!) ** 2;
    let far = 0;
    if (inside < 0) far = this.#below(out);
    for (let i = 0; i < MOST_STEPS; i++) {
      let value = -1;
      let slope = 0;
      for (let k = 0; k < 3; k++) {
        const under = 1 / (half[k]! * half[k]! + far);
        const term = (half[k]! * out[k]! * under) ** 2;
        value += term;
        slope -= 2 * term * under;
      }
      const next = far - value / slope;
      if (!(next > far)) break;
      far = next;
    }
    let square = 0;
    let size = 0;
    for (let k = 0; k < 3; k++) {
      const share = 1 / (half[k]! * half[k]! + far);
      const off = out[k]! * far * share;
      square += off * off;
      out[k]! *= share;
      size += out[k]! * out[k]!;
    }
    for (let k = 0; k < 3; k++) out[k]! /= Math.sqrt(size);
    out[3] = inside < 0 ? -Math.sqrt(square) : Math.sqrt(square);
  }

  /** Where the search for a point inside begins: where the term of one axis alone is 1. */
  #below(at: Flat): number {
    const half = this.#half;
    let most = -Infinity;
    for (let k = 0; k < 3; k++) {
      const beside = BESIDE * half[k]!;
      if (half[k] === this.#least && Math.abs(at[k]!) < beside)
        at[k] = at[k]! < 0 ? -beside : beside;
      most = Math.max(most, half[k]! * (Math.abs(at[k]!) - half[k]!));
    }
    return most;
  }
}
