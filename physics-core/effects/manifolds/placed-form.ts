import { MATRIX } from '../../base/matrix.js';
import type { Flat, Form } from '../../shapes/forms/form.js';

const local = new Float64Array(3);

/** A form where it stands in the world, in double precision. */
export class PlacedForm {
  form!: Form;
  /** Rows of the rotation, and where the form's origin is. */
  readonly turn = new Float64Array(MATRIX);
  readonly origin = new Float64Array(3);

  /** The place of another. */
  standAt({ turn, origin }: PlacedForm): void {
    this.turn.set(turn);
    this.origin.set(origin);
  }

  /** Where its part stands in a body: `turn` and `origin` in the frame of the body, whose own are `rows` and `at`. */
  put(rows: Flat, at: Flat, turn: Flat, origin: Flat): void {
    for (let i = 0; i < 3; i++) {
      const a = rows[3 * i]!;
      const b = rows[3 * i + 1]!;
      const c = rows[3 * i + 2]!;
      for (let j = 0; j < 3; j++)
        this.turn[3 * i + j] = a * turn[j]! + b * turn[3 + j]! + c * turn[6 + j]!;
      this.origin[i] = at[i]! + a * origin[0]! + b * origin[1]! + c * origin[2]!;
    }
  }

  #in(x: number, y: number, z: number, axis: number): number {
    const { turn } = this;
    return turn[axis]! * x + turn[3 + axis]! * y + turn[6 + axis]! * z;
  }

  /** One number, in the world, of a direction of the form's frame. */
  along(axis: number, direction: Flat): number {
    const { turn } = this;
    return (
      turn[3 * axis]! * direction[0]! +
      turn[3 * axis + 1]! * direction[1]! +
      turn[3 * axis + 2]! * direction[2]!
    );
  }

  /** Directions of the form's frame become those of the world. */
  #outDirection(out: Flat, at: number): void {
    const { turn } = this;
    const x = out[at]!;
    const y = out[at + 1]!;
    const z = out[at + 2]!;
    out[at] = turn[0]! * x + turn[1]! * y + turn[2]! * z;
    out[at + 1] = turn[3]! * x + turn[4]! * y + turn[5]! * z;
    out[at + 2] = turn[6]! * x + turn[7]! * y + turn[8]! * z;
  }

  /** The same of points. */
  #out(out: Flat, count: number): number {
    const { origin } = this;
    for (let at = 0; at < 3 * count; at += 3) {
      this.#outDirection(out, at);
      out[at]! += origin[0]!;
      out[at + 1]! += origin[1]!;
      out[at + 2]! += origin[2]!;
    }
    return count;
  }

  /** Into `out[at]`: the point farthest along a direction, or against it (`sign` -1), without what is round about it. */
  support(direction: Flat, sign: 1 | -1, out: Flat, at: number): void {
    const x = sign * direction[0]!;
    const y = sign * direction[1]!;
    const z = sign * direction[2]!;
    local[0] = this.#in(x, y, z, 0);
    local[1] = this.#in(x, y, z, 1);
    local[2] = this.#in(x, y, z, 2);
    this.form.support(local, local);
    const { turn, origin } = this;
    const u = local[0]!;
    const v = local[1]!;
    const w = local[2]!;
    out[at] = turn[0]! * u + turn[1]! * v + turn[2]! * w + origin[0]!;
    out[at + 1] = turn[3]! * u + turn[4]! * v + turn[5]! * w + origin[1]!;
    out[at + 2] = turn[6]! * u + turn[7]! * v + turn[8]! * w + origin[2]!;
  }

  /** How far it reaches along a unit vector, with what is round about it. */
  height(x: number, y: number, z: number): number {
    const { origin, form } = this;
    const u = this.#in(x, y, z, 0);
    const v = this.#in(x, y, z, 1);
    const w = this.#in(x, y, z, 2);
    local[0] = u;
    local[1] = v;
    local[2] = w;
    form.support(local, local);
    return (
      x * origin[0]! +
      y * origin[1]! +
      z * origin[2]! +
      local[0]! * u +
      local[1]! * v +
      local[2]! * w +
      form.round
    );
  }

  facing(x: number, y: number, z: number, out: Flat): number {
    const number = this.form.facing(
      this.#in(x, y, z, 0),
      this.#in(x, y, z, 1),
      this.#in(x, y, z, 2),
      out,
    );
    if (number >= 0) this.#outDirection(out, 0);
    return number;
  }

  face(number: number, out: Flat): number {
    return this.#out(out, this.form.face(number, out));
  }

  /** What lies on a plane along a unit vector. Level discs begin along the world's x axis, or z where that is the normal. */
  lying(x: number, y: number, z: number, out: Flat): number {
    const { turn } = this;
    const first = Math.abs(x) > 0.9 ? 6 : 0;
    const count = this.form.lying(
      this.#in(x, y, z, 0),
      this.#in(x, y, z, 1),
      this.#in(x, y, z, 2),
      turn[first]!,
      turn[first + 1]!,
      turn[first + 2]!,
      out,
    );
    return this.#rounded(x, y, z, out, this.#out(out, count));
  }

  line(x: number, y: number, z: number, out: Flat): number {
    const u = this.#in(x, y, z, 0);
    const v = this.#in(x, y, z, 1);
    const w = this.#in(x, y, z, 2);
    return this.#rounded(x, y, z, out, this.#out(out, this.form.line(u, v, w, out)));
  }

  #rounded(x: number, y: number, z: number, out: Flat, count: number): number {
    const { round } = this.form;
    for (let at = 0; at < 3 * count && round > 0; at += 3) {
      out[at]! += x * round;
      out[at + 1]! += y * round;
      out[at + 2]! += z * round;
    }
    return count;
  }
}
