import { atan2, hypot } from './exact/index.js';

/** Numbers of a rotation matrix, by rows. */
export const MATRIX = 9;

/** The rotation matrix, by rows, of the quaternion at `q[from]`. */
export function writeMatrix(
  out: Float64Array,
  at: number,
  q: ArrayLike<number>,
  from: number,
): void {
  write(out, at, q[from]!, q[from + 1]!, q[from + 2]!, q[from + 3]!);
}

/** Its columns, x first: what the axes become; the rows of the opposite turn. */
export function writeAxes(out: Float64Array, q: ArrayLike<number>, from: number): void {
  write(out, 0, q[from]!, q[from + 1]!, q[from + 2]!, -q[from + 3]!);
}

function write(out: Float64Array, at: number, x: number, y: number, z: number, w: number): void {
  out[at] = 1 - 2 * (y * y + z * z);
  out[at + 1] = 2 * (x * y - z * w);
  out[at + 2] = 2 * (x * z + y * w);
  out[at + 3] = 2 * (x * y + z * w);
  out[at + 4] = 1 - 2 * (x * x + z * z);
  out[at + 5] = 2 * (y * z - x * w);
  out[at + 6] = 2 * (x * z - y * w);
  out[at + 7] = 2 * (y * z + x * w);
  out[at + 8] = 1 - 2 * (x * x + y * y);
}

/** The spin, per second, that turns the matrix at `m[from]` into that at `m[to]` in so many seconds. */
export function writeSpin(
  out: Float64Array,
  at: number,
  m: Float64Array,
  from: number,
  to: number,
  seconds: number,
): void {
  // Twice the sine of the angle along the axis, from what is odd in to fromᵀ; the sum on its diagonal is 1 + 2 cos.
  let trace = 0;
  for (let i = 0; i < 3; i++) {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3];
    let odd = 0;
    for (let c = 0; c < 3; c++) {
      odd += m[to + k * 3 + c]! * m[from + j * 3 + c]! - m[to + j * 3 + c]! * m[from + k * 3 + c]!;
      trace += m[to + i * 3 + c]! * m[from + i * 3 + c]!;
    }
    out[at + i] = odd;
  }
  const sine = hypot(out[at]!, out[at + 1]!, out[at + 2]!) / 2;
  const share = sine > 1e-12 ? atan2(sine, (trace - 1) / 2) / (2 * sine) : 0.5;
  for (let i = at; i < at + 3; i++) out[i]! *= share / seconds;
}
