import type { Tensor } from '../mass.js';
import { BELOW, PLANE, type Cuttable, type Flat } from './cut.js';

// A cap of the unit ball as high as h, from its lowest point on.

const capVolume = (h: number): number => (Math.PI * h * h * (3 - h)) / 3;

/** Its volume times how far its middle is below that of the ball. */
const capMoment = (h: number): number => (Math.PI * (h * (2 - h)) ** 2) / 4;

const capArea = (h: number): number => Math.PI * h * (2 - h);

const heightOf = (offset: number): number => Math.min(2, Math.max(0, 1 + offset));

/**
 * A map A makes it of the unit ball, and of a plane there one here: all but lengths go with it. `squares`: A Aᵀ. A ball is one
 * of those, too.
 */
export class EllipsoidCut implements Cuttable {
  readonly #squares: Tensor;
  readonly #volume: number;

  constructor(squares: Tensor) {
    const [xx, yy, zz, xy, xz, yz] = squares;
    this.#squares = squares;
    const determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    this.#volume = Math.sqrt(Math.max(0, determinant));
  }

  below(plane: Flat, out: Flat): void {
    const { 0: xx, 1: yy, 2: zz, 3: xy, 4: xz, 5: yz } = this.#squares;
    const x = plane[PLANE.normal]!;
    const y = plane[PLANE.normal + 1]!;
    const z = plane[PLANE.normal + 2]!;
    const u = xx * x + xy * y + xz * z;
    const v = xy * x + yy * y + yz * z;
    const w = xz * x + yz * y + zz * z;
    // From its middle to the plane through its highest point.
    const reach = Math.sqrt(x * u + y * v + z * w);
    const height = heightOf(plane[PLANE.offset]! / reach);
    const moment = (-this.#volume * capMoment(height)) / reach;
    out[BELOW.volume] = this.#volume * capVolume(height);
    out[BELOW.moment] = moment * u;
    out[BELOW.moment + 1] = moment * v;
    out[BELOW.moment + 2] = moment * w;
    out[BELOW.area] = (this.#volume * capArea(height)) / reach;
  }
}

export const ballCut = (radius: number): Cuttable => {
  const square = radius * radius;
  return new EllipsoidCut([square, square, square, 0, 0, 0]);
};
