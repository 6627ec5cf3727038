import type { Seen } from './seen.js';

/** Writes the same points about each particle, in the order in which they are drawn. */
export function stamp(
  { places, order, count }: Seen,
  points: ArrayLike<number>,
  out: Float32Array,
): void {
  const { length } = points;
  for (let i = 0, to = 0; i < count; i++) {
    const at = 3 * order[i]!;
    const x = places[at]!;
    const y = places[at + 1]!;
    const z = places[at + 2]!;
    for (let k = 0; k < length; k += 3, to += 3) {
      out[to] = x + points[k]!;
      out[to + 1] = y + points[k + 1]!;
      out[to + 2] = z + points[k + 2]!;
    }
  }
}
