import { hypot } from '../../../base/exact/index.js';
import { Convex, PARALLEL, TOUCH, type Flat } from './solid.js';

/** The shares between which a way is inside the side. */
const within = new Float64Array(2);

/** A cylinder or a cone around y: its radius goes evenly from `bottom` at y = -half to `top` at y = half. */
export class FrustumSolid extends Convex {
  readonly box: Flat;
  readonly #bottom: number;
  readonly #top: number;
  readonly #half: number;
  /** The outward normal of its side, along the radius and along y, and how far out it is. */
  readonly #out: number;
  readonly #up: number;
  readonly #height: number;
  /** Of a straight line of its side, metres. */
  readonly #slant: number;

  constructor(bottom: number, top: number, half: number) {
    super();
    this.#bottom = bottom;
    this.#top = top;
    this.#half = half;
    this.#slant = hypot(2 * half, bottom - top);
    this.#out = (2 * half) / this.#slant;
    this.#up = (bottom - top) / this.#slant;
    this.#height = bottom * this.#out - half * this.#up;
    const r = Math.max(bottom, top);
    this.box = Float64Array.of(-r, -half, -r, r, half, r);
  }

  protected cut(way: Flat, out: Flat): boolean {
    const radius = way[6]!;
    const most = way[7]!;
    if (!this.#side(way)) return false;
    let enter = within[0]!;
    let exit = Math.min(most, within[1]!);
    let cap = 0;
    const end = this.#half + radius;
    const y = way[1]!;
    const v = way[4]!;
    if (Math.abs(v) <= PARALLEL) {
      if (!(Math.abs(y) <= end + TOUCH)) return false;
    } else {
      const first = ((v > 0 ? -end : end) - y) / v;
      const last = ((v > 0 ? end : -end) - y) / v;
      if (first > enter) {
        enter = first;
        cap = v > 0 ? -1 : 1;
      }
      if (last < exit) exit = last;
    }
    if (!(enter <= exit && exit >= 0)) return false;
    out[0] = enter;
    const share = enter > -Infinity ? enter : 0;
    const x = way[0]! + way[3]! * share;
    const z = way[2]! + way[5]! * share;
    const across = Math.sqrt(x * x + z * z);
    out[4] = radius <= TOUCH ? 1 : 0;
    if (cap !== 0) {
      out[1] = out[3] = 0;
      out[2] = cap;
      if (across <= (cap > 0 ? this.#top : this.#bottom)) out[4] = 1;
      return true;
    }
    this.#turn(x, z, across, this.#out, this.#up, out, 1);
    if (Math.abs(y + v * share - radius * this.#up) <= this.#half) out[4] = 1;
    return true;
  }

  /** A normal along the radius and y as one in space. */
  #turn(
    x: number,
    z: number,
    across: number,
    along: number,
    up: number,
    out: Flat,
    at: number,
  ): void {
    out[at] = across > 0 ? (x / across) * along : along;
    out[at + 1] = up;
    out[at + 2] = across > 0 ? (z / across) * along : 0;
  }

  /** Where it is inside the side, without ends: a half of a double cone, or a pipe. */
  #side(way: Flat): boolean {
    const x = way[0]!;
    const z = way[2]!;
    const u = way[3]!;
    const w = way[5]!;
    // The radius there is (rest + fall · share) / out.
    const rest = this.#height + way[6]! - this.#up * way[1]!;
    const fall = -this.#up * way[4]!;
    const square = this.#out * this.#out;
    const a = square * (u * u + w * w) - fall * fall;
    const b = square * (x * u + z * w) - rest * fall;
    const c = square * (x * x + z * z) - rest * rest;
    within[0] = -Infinity;
    within[1] = Infinity;
    if (Math.abs(a) <= PARALLEL ** 2) {
      if (Math.abs(b) <= PARALLEL * Math.abs(rest)) return c <= TOUCH * Math.abs(rest) && rest >= 0;
      // Along a line of the side: it goes in, or out, once.
      within[b < 0 ? 0 : 1] = -c / (2 * b);
      return b < 0 ? fall >= 0 : fall <= 0;
    }
    const inner = b * b - a * c;
    if (!(inner >= 0)) return false;
    // The sum that loses no digits.
    const sum = -(b + (b < 0 ? -Math.sqrt(inner) : Math.sqrt(inner)));
    const one = sum / a;
    const other = sum === 0 ? one : c / sum;
    const low = Math.min(one, other);
    const high = Math.max(one, other);
    if (a > 0) {
      within[0] = low;
      within[1] = high;
      return rest - (fall * b) / a >= 0;
    }
    // So steep that it leaves one half of the double cone and enters the other.
    if (fall > 0) within[0] = high;
    else within[1] = low;
    return true;
  }

  gap(at: Flat, out: Flat): void {
    const x = at[0]!;
    const y = at[1]!;
    const z = at[2]!;
    const half = this.#half;
    const across = Math.sqrt(x * x + z * z);
    const below = -half - y;
    const above = y - half;
    const side = across * this.#out + y * this.#up - this.#height;
    if (below > 0 ? across <= this.#bottom : below >= side && below >= above) {
      this.#turn(x, z, across, 0, -1, out, 0);
      out[3] = below;
      return;
    }
    if (above > 0 ? across <= this.#top : above >= side && above >= below) {
      this.#turn(x, z, across, 0, 1, out, 0);
      out[3] = above;
      return;
    }
    const along = (y + half) * this.#out - (across - this.#bottom) * this.#up;
    const isInside = side <= 0 && below <= 0 && above <= 0;
    if (isInside || (along >= 0 && along <= this.#slant)) {
      this.#turn(x, z, across, this.#out, this.#up, out, 0);
      out[3] = side;
      return;
    }
    const out2 = across - (along < 0 ? this.#bottom : this.#top);
    const up2 = along < 0 ? -below : above;
    const distance = Math.sqrt(out2 * out2 + up2 * up2);
    if (distance <= TOUCH) this.#turn(x, z, across, this.#out, this.#up, out, 0);
    else this.#turn(x, z, across, out2 / distance, up2 / distance, out, 0);
    out[3] = distance;
  }
}
