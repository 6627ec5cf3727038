import type { Vec3 } from '../../fields/types.js';
import type { Tensor } from '../mass.js';
import type { Flat, Silhouette } from './silhouette.js';

// What is the same about its middle is seen about that, from wherever.

const middle = (area: number, out: Flat): void => {
  out[0] = area;
  out[1] = out[2] = out[3] = 0;
};

export class BallSilhouette implements Silhouette {
  readonly #area: number;

  constructor(radius: number) {
    this.#area = Math.PI * radius * radius;
  }

  along(_: Flat, out: Flat): void {
    middle(this.#area, out);
  }
}

/** Three of its faces are turned to who looks. */
export class BoxSilhouette implements Silhouette {
  readonly #faces: Vec3;

  constructor([x, y, z]: Vec3) {
    this.#faces = [4 * y * z, 4 * x * z, 4 * x * y];
  }

  along(way: Flat, out: Flat): void {
    let area = 0;
    for (let i = 0; i < 3; i++) area += this.#faces[i]! * Math.abs(way[i]!);
    middle(area, out);
  }
}

/**
 * A map A makes it of the unit ball, and what is seen along w of that a disc: its area is π |det A| |A⁻¹ w|, of which the
 * square is π² wᵀ adj(A Aᵀ) w.
 */
export class EllipsoidSilhouette implements Silhouette {
  readonly #adjugate: Tensor;

  /** A Aᵀ. */
  constructor([xx, yy, zz, xy, xz, yz]: Tensor) {
    this.#adjugate = [
      yy * zz - yz * yz,
      xx * zz - xz * xz,
      xx * yy - xy * xy,
      xz * yz - xy * zz,
      xy * yz - xz * yy,
      xy * xz - xx * yz,
    ];
  }

  along(way: Flat, out: Flat): void {
    const { 0: xx, 1: yy, 2: zz, 3: xy, 4: xz, 5: yz } = this.#adjugate;
    const x = way[0]!;
    const y = way[1]!;
    const z = way[2]!;
    const square =
      xx * x * x + yy * y * y + zz * z * z + 2 * (xy * x * y + xz * x * z + yz * y * z);
    middle(Math.PI * Math.sqrt(Math.max(0, square)), out);
  }
}
