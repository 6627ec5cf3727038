import earcut from 'earcut';
import type { Vec3 } from '../fields/types.js';

/** Share of a face's area by which a triangle of its fan may lie the wrong way round: points on a line do in single precision. */
const ROUNDING = 1e-7;

/** As a fan, whatever its form. */
export const fan = (face: number[]): number[] =>
  face.slice(2).flatMap((c, i) => [face[0]!, face[i + 1]!, c]);

/** Seen from the first one, so that a face far from the origin loses no digits. */
const cornersOf = (points: number[], face: number[]): Vec3[] =>
  face.map(
    (i) => [0, 1, 2].map((axis) => points[3 * i + axis]! - points[3 * face[0]! + axis]!) as Vec3,
  );

/** Newell's normal of a closed line of points: twice its area long, and right for points not quite in a plane. */
function normalOf(corners: Vec3[]): Vec3 {
  const normal: Vec3 = [0, 0, 0];
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % corners.length]!;
    normal[0] += (a[1] - b[1]) * (a[2] + b[2]);
    normal[1] += (a[2] - b[2]) * (a[0] + b[0]);
    normal[2] += (a[0] - b[0]) * (a[1] + b[1]);
  });
  return normal;
}

/** Along the axis nearest to the normal, counterclockwise. */
function flattened(corners: Vec3[], normal: Vec3): number[] {
  const lengths = normal.map(Math.abs);
  const along = lengths.indexOf(Math.max(...lengths));
  const sides = [(along + 1) % 3, (along + 2) % 3];
  if (normal[along]! < 0) sides.reverse();
  return corners.flatMap((p) => sides.map((side) => p[side]!));
}

/** Whether no triangle of the fan lies the wrong way round; `flat` has its hub at the origin. */
function isFan(flat: number[]): boolean {
  let sum = 0;
  let least = 0;
  for (let i = 2; i + 3 < flat.length; i += 2) {
    const area = flat[i]! * flat[i + 3]! - flat[i + 1]! * flat[i + 2]!;
    sum += area;
    least = Math.min(least, area);
  }
  return least >= -ROUNDING * Math.abs(sum);
}

/**
 * The triangles of a face. X3D's `convex` is no matter: where a fan covers the face it is a fan, and nothing is said in the
 * standard of a concave face that is called convex. Of one without an area, or whose points are not there, the fan is as good
 * as any.
 */
export function trianglesOfFace(points: number[], face: number[]): number[] {
  const count = Math.floor(points.length / 3);
  if (face.length <= 3 || face.some((i) => i < 0 || i >= count)) return fan(face);
  const corners = cornersOf(points, face);
  const normal = normalOf(corners);
  if (!normal.some((value) => value !== 0)) return fan(face);
  const flat = flattened(corners, normal);
  if (isFan(flat)) return fan(face);
  const triangles = earcut(flat).map((at) => face[at]!);
  return triangles.length > 0 ? triangles : fan(face);
}
