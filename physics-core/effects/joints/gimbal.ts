import { atan2 } from '../../base/exact/index.js';
import { asin } from '../../base/exact/asin.js';
import { cross3, dot3 } from '../../base/flat-math.js';

/**
 * The three angles of one frame against another as Bullet's 6-DoF has them, rows 3 to 5: about x of frame 2, about what is
 * at right angles to both other axes, and about z of frame 1. Axes are x, y, z, three numbers each.
 */
export class Gimbal {
  #one: Float64Array = new Float64Array(9);
  #two: Float64Array = new Float64Array(9);
  /** At right angles to both other axes, and the cosine of the angle about it: only once an axis is asked for. */
  readonly #middle = new Float64Array(3);
  #cosine = 1;
  #stale = true;

  look(one: Float64Array, two: Float64Array): void {
    this.#one = one;
    this.#two = two;
    this.#stale = true;
  }

  #findMiddle(): void {
    const m = this.#middle;
    const one = this.#one;
    const two = this.#two;
    this.#stale = false;
    cross3(m, 0, one, 6, two, 0);
    this.#cosine = Math.sqrt(dot3(m, 0, m, 0)) || 1;
    for (let x = 0; x < 3; x++) m[x]! /= this.#cosine;
  }

  /** Radians. */
  angle(row: number): number {
    const one = this.#one;
    const two = this.#two;
    if (row === 3) return atan2(-dot3(one, 6, two, 3), dot3(one, 6, two, 6));
    if (row === 5) return atan2(-dot3(two, 0, one, 3), dot3(two, 0, one, 0));
    return asin(Math.max(-1, Math.min(1, dot3(one, 6, two, 0))));
  }

  /** The axis that Bullet pushes about. */
  writeAxis(row: number, out: Float64Array, at: number): void {
    if (this.#stale) this.#findMiddle();
    if (row === 3) cross3(out, at, this.#middle, 0, this.#one, 6);
    else if (row === 5) cross3(out, at, this.#two, 0, this.#middle, 0);
    else for (let x = 0; x < 3; x++) out[at + x] = this.#middle[x]!;
  }

  /** What gives the rate of the angle while the other two stand: not quite its axis where two are not at right angles. */
  writeRate(row: number, out: Float64Array, at: number): void {
    this.writeAxis(row, out, at);
    if (row !== 4) for (let x = at; x < at + 3; x++) out[x]! /= this.#cosine;
  }
}
