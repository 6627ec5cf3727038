import { cos, hypot, sin } from '../../base/exact/index.js';
import type { Flat, Form } from './form.js';

/** Corners that stand for the rim of a disc. */
const RIM = 16;

const ANGLES = Float64Array.from({ length: RIM }, (_, i) => (2 * Math.PI * i) / RIM);
const COSINES = ANGLES.map(cos);
const SINES = ANGLES.map(sin);

/** A disc whose rim is lowered by less than this all across lies level, metres: the depth that resting contacts keep. */
const LEVEL = 1e-4;

/** Within this angle from it, in radians, a straight line of the surface lies along a plane. */
const ALONG = 0.02;

/** A cylinder or a cone around y: its radius goes evenly from `bottom` at y = -half to `top` at y = half. */
export class FrustumForm implements Form {
  readonly round = 0;
  readonly cornered = false;
  readonly reach: number;
  readonly #bottom: number;
  readonly #top: number;
  readonly #half: number;
  /** The outward normal of its side: along the radius, and along y. */
  readonly #out: number;
  readonly #up: number;

  constructor(bottom: number, top: number, half: number) {
    this.#bottom = bottom;
    this.#top = top;
    this.#half = half;
    this.reach = hypot(Math.max(bottom, top), half);
    const slant = hypot(2 * half, bottom - top);
    this.#out = (2 * half) / slant;
    this.#up = (bottom - top) / slant;
  }

  support(direction: Flat, out: Flat): void {
    const x = direction[0]!;
    const y = direction[1]!;
    const z = direction[2]!;
    const across = hypot(x, z);
    const atTop = across * this.#top + y * this.#half > across * this.#bottom - y * this.#half;
    this.#rim(atTop, x, z, across, out, 0);
  }

  /** The point of a rim along (x, z), whose length is `across`. */
  #rim(atTop: boolean, x: number, z: number, across: number, out: Flat, at: number): void {
    const radius = across > 0 ? (atTop ? this.#top : this.#bottom) / across : 0;
    out[at] = x * radius;
    out[at + 1] = atTop ? this.#half : -this.#half;
    out[at + 2] = z * radius;
  }

  facing(_x: number, y: number, _z: number, out: Flat): number {
    const atTop = y > 0 && this.#top > 0;
    out[0] = out[2] = 0;
    out[1] = atTop ? 1 : -1;
    return atTop ? 1 : 0;
  }

  face(number: number, out: Flat): number {
    return this.#disc(number === 1, 1, 0, out);
  }

  /** Points of a rim from the one along the unit vector (x, z) on. */
  #disc(atTop: boolean, x: number, z: number, out: Flat): number {
    const radius = atTop ? this.#top : this.#bottom;
    const y = atTop ? this.#half : -this.#half;
    // Against the clock as seen from outside.
    const way = atTop ? -radius : radius;
    for (let i = 0; i < RIM; i++) {
      const c = COSINES[i]! * radius;
      const s = SINES[i]! * way;
      out[3 * i] = c * x - s * z;
      out[3 * i + 1] = y;
      out[3 * i + 2] = s * x + c * z;
    }
    return RIM;
  }

  lying(x: number, y: number, z: number, u: number, _v: number, w: number, out: Flat): number {
    const across = hypot(x, z);
    const side = across * this.#out + y * this.#up;
    const top = this.#top > 0 ? y : -1;
    if (side >= top && side >= -y) return this.#generatrix(x, z, across, out);
    const atTop = top > -y;
    const radius = atTop ? this.#top : this.#bottom;
    if (2 * radius * across > LEVEL) return this.#disc(atTop, x / across, z / across, out);
    const size = hypot(u, w);
    return size > 0 ? this.#disc(atTop, u / size, w / size, out) : this.#disc(atTop, 1, 0, out);
  }

  #generatrix(x: number, z: number, across: number, out: Flat): number {
    this.#rim(false, x, z, across, out, 0);
    this.#rim(true, x, z, across, out, 3);
    return 2;
  }

  line(x: number, y: number, z: number, out: Flat): number {
    const across = hypot(x, z);
    // The sine of the angle between the line and the plane.
    if (Math.abs(y * this.#out - across * this.#up) < ALONG)
      return this.#generatrix(x, z, across, out);
    out[0] = x;
    out[1] = y;
    out[2] = z;
    this.support(out, out);
    return 1;
  }
}
