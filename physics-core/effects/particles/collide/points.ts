import type { Flat } from './solid.js';

/** Around points, three numbers each: least x y z, greatest x y z. */
export function boxOfPoints(points: Flat): Flat {
  const box = Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
  for (let i = 0; i < points.length; i++) {
    const k = i % 3;
    box[k] = Math.min(box[k]!, points[i]!);
    box[3 + k] = Math.max(box[3 + k]!, points[i]!);
  }
  return box;
}
