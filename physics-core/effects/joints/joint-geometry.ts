import { Gimbal } from './gimbal.js';

/** Rows 0 to 2 lie along axes, rows 3 to 5 are about them. */
export const LINEAR = 3;

/** The frame of a joint as one side carries it, world: its origin, and its axes x, y, z, three numbers each. */
export class End {
  readonly origin = new Float64Array(3);
  readonly axes = new Float64Array(9);
}

/**
 * The rows of a joint as Bullet's 6-DoF has them, from where both its ends are now: 0 to 2 move body 1 against body 2 along
 * the axes of frame 1, 3 to 5 turn it about x of frame 2, about what is at right angles to both, and about z of frame 1.
 */
export class JointGeometry {
  readonly one = new End();
  readonly two = new End();
  readonly #gimbal = new Gimbal();

  /** Both ends are read: before anything is asked about angles. */
  look(): void {
    this.#gimbal.look(this.one.axes, this.two.axes);
  }

  /** Where a row stands, metres or radians; 0 at the poses the joint was made at. */
  value(row: number): number {
    if (row >= LINEAR) return this.#gimbal.angle(row);
    const { axes: one, origin: c1 } = this.one;
    const { origin: c2 } = this.two;
    const n = row * 3;
    return (
      one[n]! * (c1[0]! - c2[0]!) +
      one[n + 1]! * (c1[1]! - c2[1]!) +
      one[n + 2]! * (c1[2]! - c2[2]!)
    );
  }

  /**
   * A row along an axis that body 1 carries, at the point that body 2 carries (what slides is measured there), as the body
   * sees it whose centre of mass is `centre[c]`: six numbers from `out[at]` on. `sign`: 1 for body 1, -1 for body 2.
   */
  writeLinear(
    out: Float64Array,
    at: number,
    row: number,
    centre: Float64Array,
    c: number,
    sign: 1 | -1,
  ): void {
    this.writeAlong(out, at, row, sign);
    const n = row * 3;
    const axis = this.one.axes;
    const { origin } = this.two;
    const x = origin[0]! - centre[c]!;
    const y = origin[1]! - centre[c + 1]!;
    const z = origin[2]! - centre[c + 2]!;
    out[at + 3] = sign * (y * axis[n + 2]! - z * axis[n + 1]!);
    out[at + 4] = sign * (z * axis[n]! - x * axis[n + 2]!);
    out[at + 5] = sign * (x * axis[n + 1]! - y * axis[n]!);
  }

  /** Only the three numbers that go with the linear velocity. */
  writeAlong(out: Float64Array, at: number, row: number, sign: 1 | -1): void {
    for (let x = 0; x < 3; x++) out[at + x] = sign * this.one.axes[row * 3 + x]!;
  }

  /** The rate of one of three angles while the other two stand, as body 1 sees it at `one` and body 2 at `two`. */
  writeAngular(out: Float64Array, one: number, two: number, row: number): void {
    this.#gimbal.writeRate(row, out, one + 3);
    for (let x = 0; x < 3; x++) {
      out[one + x] = out[two + x] = 0;
      out[two + 3 + x] = -out[one + 3 + x]!;
    }
  }
}
