import { cross, length, normalize, perpendicular, subtract } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import { compact, outlineOf } from './hull-faces.js';
import type { Faces } from './polytope.js';

/** What bounds points in one plane, on one line or at one place: a sheet with two faces. `points` are flat. */
export function flatFaces(points: readonly number[]): Faces {
  const all = [...Array(Math.floor(points.length / 3)).keys()];
  const at = (i: number): Vec3 => [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
  const farthest = (measure: (at: Vec3) => number): number =>
    all.reduce((best, i) => (measure(at(i)) > measure(at(best)) ? i : best), 0);
  const from = (corner: number) => (p: Vec3) => length(subtract(p, at(corner)));
  const first = farthest(from(0));
  const last = farthest(from(first));
  const along = subtract(at(last), at(first));
  const across = (p: Vec3): Vec3 => cross(along, subtract(p, at(first)));
  const widest = across(at(farthest((p) => length(across(p)))));
  // What is as wide as rounding is a line.
  const isLine = length(widest) <= THIN * length(along) ** 2;
  const normal = isLine ? perpendicular(normalize(along)) : normalize(widest);
  const face = isLine ? [...new Set([first, last])] : outlineOf(points, new Set(all), normal);
  const [x, y, z] = normal;
  return compact(points, [face, [...face].reverse()], Float64Array.of(x, y, z, -x, -y, -z));
}

/** Width of a line as a share of its length: what single precision leaves. */
const THIN = 1e-7;
