import type { Flat, Form } from './form.js';

/** Of a symmetric matrix. */
type Squares = readonly [xx: number, yy: number, zz: number, xy: number, xz: number, yz: number];

/** What a linear map makes of a ball: an egg, a lens, turned any way. */
export class EllipsoidForm implements Form {
  readonly round = 0;
  readonly cornered = false;
  readonly reach: number;
  /** M of nᵀ M n, the square of how far it reaches along n. */
  readonly #squares: Squares;

  /** `reach`: the longest of its half axes. */
  constructor(squares: Squares, reach: number) {
    this.#squares = squares;
    this.reach = reach;
  }

  support(direction: Flat, out: Flat): void {
    const x = direction[0]!;
    const y = direction[1]!;
    const z = direction[2]!;
    // By index: to go through it as a list takes as long as the rest.
    const { 0: xx, 1: yy, 2: zz, 3: xy, 4: xz, 5: yz } = this.#squares;
    const u = xx * x + xy * y + xz * z;
    const v = xy * x + yy * y + yz * z;
    const w = xz * x + yz * y + zz * z;
    const square = x * u + y * v + z * w;
    const size = square > 0 ? 1 / Math.sqrt(square) : 0;
    out[0] = u * size;
    out[1] = v * size;
    out[2] = w * size;
  }

  facing(): number {
    return -1;
  }

  face(): number {
    return 0;
  }

  lying(x: number, y: number, z: number, _u: number, _v: number, _w: number, out: Flat): number {
    out[0] = x;
    out[1] = y;
    out[2] = z;
    this.support(out, out);
    return 1;
  }

  line(x: number, y: number, z: number, out: Flat): number {
    out[0] = x;
    out[1] = y;
    out[2] = z;
    this.support(out, out);
    return 1;
  }
}
