import { sin } from '../../../base/exact/index.js';
import type { Draws } from './draws.js';

/** Directions within an angle of an axis, or anywhere: those of a cap of the sphere. */
export class Cap {
  /** The axis, and two across it. */
  readonly #axes = Float64Array.of(0, 0, 1, 1, 0, 0, 0, 1, 0);
  /** How far the axis' share falls from the middle to the rim. */
  #depth = 2;

  /** `angle`: from the axis to the rim, radians. 0 0 0 has no direction: anywhere. */
  take(x: number, y: number, z: number, angle: number): this {
    // However long or short: its square may be no number.
    const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
    const length = most * Math.sqrt((x / most) ** 2 + (y / most) ** 2 + (z / most) ** 2);
    const somewhere = most > 0 && Number.isFinite(length);
    const half = sin(angle / 2);
    // 1 - cos of the angle, which would lose the digits of a narrow cap.
    this.#depth = somewhere ? 2 * half * half : 2;
    if (somewhere) this.#turn(x / length, y / length, z / length);
    else this.#turn(0, 0, 1);
    return this;
  }

  /** Two unit vectors across a third (Duff and others, Building an Orthonormal Basis, Revisited, 2017). */
  #turn(x: number, y: number, z: number): void {
    const axes = this.#axes;
    const sign = z < 0 ? -1 : 1;
    const a = -1 / (sign + z);
    const b = x * y * a;
    axes[0] = x;
    axes[1] = y;
    axes[2] = z;
    axes[3] = 1 + sign * x * x * a;
    axes[4] = sign * b;
    axes[5] = -sign * x;
    axes[6] = b;
    axes[7] = sign + y * y * a;
    axes[8] = -y;
  }

  /**
   * A unit vector, evenly over the cap: the square of how far a point drawn in a disc lies from its middle is spread as evenly
   * as the axis' share over a cap is (Marsaglia 1972), which takes no sine.
   */
  draw(draws: Draws, out: Float64Array, at: number): void {
    let u = 0;
    let v = 0;
    let square = 0;
    do {
      u = draws.either();
      v = draws.either();
      square = u * u + v * v;
    } while (square >= 1);
    const fall = square * this.#depth;
    const rise = 1 - fall;
    // Of √(1 - rise²) / √square: what is left of it near the middle is no 0 / 0.
    const across = Math.sqrt(this.#depth * (2 - fall));
    const axes = this.#axes;
    for (let i = 0; i < 3; i++)
      out[at + i] = rise * axes[i]! + across * (u * axes[3 + i]! + v * axes[6 + i]!);
  }
}
