import { hypot } from '../../base/exact/index.js';
import { MOST_CORNERS } from './form.js';
import type { Faces } from './polytope.js';

/** Share of its size by which a corner may stand out of a face that it belongs to: what single precision leaves of a plane. */
const FLAT = 1e-5;

type Triangle = readonly [number, number, number];

/**
 * The faces of a convex hull: triangles in one plane become one face. Triangles go against the clock as seen from outside;
 * `points` are flat, three numbers each.
 */
export function hullFaces(points: ArrayLike<number>, triangles: readonly Triangle[]): Faces {
  const size = sizeOf(points, triangles);
  const planes = triangles.map((triangle) => planeOf(points, triangle));
  const faces: number[][] = [];
  const normals: number[] = [];
  const open = new Set(triangles.keys());
  const largest = [...triangles.keys()].sort((i, j) => planes[j]!.area - planes[i]!.area);
  const across = neighbours(points.length / 3, triangles);
  for (const first of largest) {
    if (!open.delete(first)) continue;
    const { normal, height } = planes[first]!;
    const lies = (corner: number): boolean =>
      Math.abs(along(points, corner, normal) - height) <= FLAT * size;
    const group = [first];
    const corners = new Set(triangles[first]);
    for (const one of group)
      for (const next of across[one]!)
        if (open.has(next) && triangles[next]!.every(lies)) {
          open.delete(next);
          group.push(next);
          for (const corner of triangles[next]!) corners.add(corner);
        }
    faces.push(outlineOf(points, corners, normal));
    normals.push(...normal);
  }
  return compact(points, faces, Float64Array.from(normals));
}

export type Vector = [number, number, number];

const along = (points: ArrayLike<number>, corner: number, [x, y, z]: Vector): number =>
  points[3 * corner]! * x + points[3 * corner + 1]! * y + points[3 * corner + 2]! * z;

function sizeOf(points: ArrayLike<number>, triangles: readonly Triangle[]): number {
  let size = 0;
  for (const triangle of triangles)
    for (const corner of triangle)
      for (let i = 0; i < 3; i++) size = Math.max(size, Math.abs(points[3 * corner + i]!));
  return size;
}

function planeOf(points: ArrayLike<number>, [a, b, c]: Triangle) {
  const side = (from: number, to: number, i: number) => points[3 * to + i]! - points[3 * from + i]!;
  const ux = side(a, b, 0);
  const uy = side(a, b, 1);
  const uz = side(a, b, 2);
  const vx = side(a, c, 0);
  const vy = side(a, c, 1);
  const vz = side(a, c, 2);
  const x = uy * vz - uz * vy;
  const y = uz * vx - ux * vz;
  const z = ux * vy - uy * vx;
  const area = hypot(x, y, z);
  const normal: Vector = area > 0 ? [x / area, y / area, z / area] : [0, 0, 0];
  return { area, normal, height: along(points, a, normal) };
}

/** Of each triangle those that share a side with it; `count`: corners that there are. */
function neighbours(count: number, triangles: readonly Triangle[]): number[][] {
  /** By a side's ends. */
  const sides = new Map<number, number>();
  for (const [one, [a, b, c]] of triangles.entries()) {
    sides.set(count * a + b, one);
    sides.set(count * b + c, one);
    sides.set(count * c + a, one);
  }
  return triangles.map(([a, b, c]) =>
    [count * b + a, count * c + b, count * a + c]
      .map((side) => sides.get(side))
      .filter((next) => next !== undefined),
  );
}

/** Corners of a flat convex face in order around it, without those on its edges. */
export function outlineOf(
  points: ArrayLike<number>,
  corners: Set<number>,
  normal: Vector,
): number[] {
  const [x, y, z] = normal;
  // Two directions in the plane, the normal being the third.
  const u: Vector = Math.abs(x) > 0.7 ? [-y, x, 0] : [0, -z, y];
  const v: Vector = [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]];
  const flat = [...corners].map((corner) => ({
    corner,
    x: along(points, corner, u),
    y: along(points, corner, v),
  }));
  flat.sort((a, b) => a.x - b.x || a.y - b.y);
  const chain = (all: typeof flat): typeof flat => {
    const kept: typeof flat = [];
    for (const next of all) {
      while (kept.length > 1 && !turnsLeft(kept.at(-2)!, kept.at(-1)!, next)) kept.pop();
      kept.push(next);
    }
    kept.pop();
    return kept;
  };
  const around = [...chain(flat), ...chain(flat.reverse())].map(({ corner }) => corner);
  const step = Math.ceil(around.length / MOST_CORNERS);
  return around.filter((_, i) => i % step === 0);
}

interface Flat2 {
  x: number;
  y: number;
}

/** Whether the way from a over b to c bends to the left, by more than rounding. */
function turnsLeft(a: Flat2, b: Flat2, c: Flat2): boolean {
  const ux = b.x - a.x;
  const uy = b.y - a.y;
  const vx = c.x - b.x;
  const vy = c.y - b.y;
  return ux * vy - uy * vx > 1e-7 * hypot(ux, uy) * hypot(vx, vy);
}

/** With only the corners that faces have. */
export function compact(
  points: ArrayLike<number>,
  faces: number[][],
  normals: Float64Array,
): Faces {
  /** By their old numbers: the new ones, in the same order. */
  const numbers = new Int32Array(Math.floor(points.length / 3)).fill(-1);
  for (const face of faces) for (const corner of face) numbers[corner] = 0;
  const kept: number[] = [];
  for (const [corner, number] of numbers.entries()) {
    if (number < 0) continue;
    numbers[corner] = kept.length / 3;
    for (let i = 3 * corner; i < 3 * corner + 3; i++) kept.push(points[i]!);
  }
  return {
    points: Float64Array.from(kept),
    faces: faces.map((face) => face.map((corner) => numbers[corner]!)),
    normals,
  };
}
