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
