/** Numbers of a rotation matrix, by rows. */
export const MATRIX = 9;

/** The rotation matrix, by rows, of the quaternion at `q[from]`. */
export function writeMatrix(out: Float64Array, at: number, q: Float64Array, from: number): void {
  const x = q[from]!;
  const y = q[from + 1]!;
  const z = q[from + 2]!;
  const w = q[from + 3]!;
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
