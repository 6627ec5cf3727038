/** Of the triangle that was measured last: its normal, as long as its area, m²; and its middle. */
export const normal = new Float64Array(3);
export const middle = new Float64Array(3);

export const sizeOf = (v: Float64Array): number =>
  Math.sqrt(v[0]! * v[0]! + v[1]! * v[1]! + v[2]! * v[2]!);

/** Into `normal` and `middle`. */
export function measure(places: Float64Array, i: number, j: number, m: number): void {
  const x = places[3 * i]!;
  const y = places[3 * i + 1]!;
  const z = places[3 * i + 2]!;
  const ux = places[3 * j]! - x;
  const uy = places[3 * j + 1]! - y;
  const uz = places[3 * j + 2]! - z;
  const vx = places[3 * m]! - x;
  const vy = places[3 * m + 1]! - y;
  const vz = places[3 * m + 2]! - z;
  normal[0] = (uy * vz - uz * vy) / 2;
  normal[1] = (uz * vx - ux * vz) / 2;
  normal[2] = (ux * vy - uy * vx) / 2;
  middle[0] = x + (ux + vx) / 3;
  middle[1] = y + (uy + vy) / 3;
  middle[2] = z + (uz + vz) / 3;
}

/** The square of how far points are apart. */
export function apart(places: Float64Array, i: number, j: number): number {
  let square = 0;
  for (let k = 0; k < 3; k++) square += (places[3 * i + k]! - places[3 * j + k]!) ** 2;
  return square;
}
