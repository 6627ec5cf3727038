import { subtract } from '../../../base/math.js';
import type { Vec3 } from '../../../fields/types.js';
import type { Mesh } from '../../../shapes/geometry.js';
import { areFinite } from './finite.js';

/** Numbers of a triangle: its corners, metres. */
export const TRIANGLE = 9;

/** The triangles of a mesh, one after the other; none where an index or a number of one is amiss. */
export function trianglesOf({ points, index }: Mesh): Float64Array {
  const corners = index.slice(0, index.length - (index.length % 3));
  const triangles = new Float64Array(corners.length * 3);
  for (let i = 0; i < triangles.length; i++)
    triangles[i] = points[3 * corners[Math.floor(i / 3)]! + (i % 3)]!;
  // An index of no point leaves numbers that are none.
  return corners.every(Number.isInteger) && areFinite(triangles) ? triangles : new Float64Array(0);
}

/** Metres. */
export interface Box {
  least: Vec3;
  sides: Vec3;
}

/** What the triangles lie in. */
export function boxOf(triangles: Float64Array): Box {
  const least: Vec3 = [Infinity, Infinity, Infinity];
  const most: Vec3 = [-Infinity, -Infinity, -Infinity];
  triangles.forEach((value, i) => {
    least[i % 3] = Math.min(least[i % 3]!, value);
    most[i % 3] = Math.max(most[i % 3]!, value);
  });
  return { least, sides: subtract(most, least) };
}
