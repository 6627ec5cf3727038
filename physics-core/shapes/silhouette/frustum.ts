import { atan2, hypot } from '../../base/exact/index.js';
import type { Flat, Silhouette } from './silhouette.js';

/** A cylinder or a cone around y: its radius goes evenly from `bottom` at y = -half to `top` at y = half. */
export class FrustumSilhouette implements Silhouette {
  readonly #bottom: number;
  readonly #top: number;
  readonly #half: number;

  constructor(bottom: number, top: number, half: number) {
    this.#bottom = bottom;
    this.#top = top;
    this.#half = half;
  }

  along(way: Flat, out: Flat): void {
    const up = -way[1]!;
    const across = hypot(way[0]!, way[2]!);
    this.#side(way, across, up, out);
    // The disc that is turned to who looks.
    const radius = up > 0 ? this.#top : this.#bottom;
    const disc = Math.PI * radius * radius * Math.abs(up);
    out[0] = out[0]! + disc;
    out[2] = out[2]! + (up > 0 ? disc : -disc) * this.#half;
  }

  /**
   * At an angle φ from who looks, an eye at (across, up), the side is turned to it by a cos φ + b as a share of its slant
   * length: sums of that to the angle where it is turned away.
   */
  #side(way: Flat, across: number, up: number, out: Flat): void {
    const bottom = this.#bottom;
    const top = this.#top;
    const half = this.#half;
    const a = 2 * half * across;
    const b = (bottom - top) * up;
    const root = Math.sqrt(Math.max(0, a * a - b * b));
    const angle = atan2(root, -b);
    const sine = a > Math.abs(b) ? root / a : 0;
    const cosine = a > Math.abs(b) ? -b / a : 0;
    const seen = 2 * (a * sine + b * angle);
    const off = a * (angle + sine * cosine) + 2 * b * sine;
    const aside =
      across > 0 ? (off * (bottom * bottom + bottom * top + top * top)) / 3 / across : 0;
    out[0] = (seen * (bottom + top)) / 2;
    out[1] = -way[0]! * aside;
    out[2] = (-seen * (bottom - top) * half) / 6;
    out[3] = -way[2]! * aside;
  }
}
