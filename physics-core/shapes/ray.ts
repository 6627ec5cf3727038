import type { Vec3 } from '../fields/types.js';
import { add, cross, dot, scale, subtract } from '../base/math.js';
import type { Geometry } from './geometry.js';

/** Where a line enters a solid: the share of its way, and the outward normal there (of any length). */
export interface Entry {
  share: number;
  normal: Vec3;
}

const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** A stretch of a line inside some part of space, and the normal where it begins. */
interface Inside {
  from: number;
  to: number;
  normal: Vec3;
}

const NOWHERE: Inside = { from: Infinity, to: -Infinity, normal: [0, 0, 0] };

/** Between two planes at right angles to an axis. */
function slab(at: Vec3, way: Vec3, axis: number, low: number, high: number): Inside {
  const unit = [0, 1, 2].map((i) => (i === axis ? 1 : 0)) as Vec3;
  const [p, d] = [at[axis]!, way[axis]!];
  if (d === 0)
    return p >= low && p <= high ? { from: -Infinity, to: Infinity, normal: unit } : NOWHERE;
  const [from, to] = d > 0 ? [(low - p) / d, (high - p) / d] : [(high - p) / d, (low - p) / d];
  return { from, to, normal: scale(unit, -Math.sign(d)) };
}

/** Where a t² + 2 b t + c is below zero. */
function quadric(a: number, b: number, c: number, normalAt: (share: number) => Vec3): Inside {
  const inner = b * b - a * c;
  if (a <= 0 || inner < 0)
    return a === 0 && c <= 0 ? { from: -Infinity, to: Infinity, normal: [0, 1, 0] } : NOWHERE;
  const [from, to] = [(-b - Math.sqrt(inner)) / a, (-b + Math.sqrt(inner)) / a];
  return { from, to, normal: normalAt(from) };
}

/** In all of them: it enters where it enters the last. */
function common(parts: Inside[]): Entry | null {
  const last = parts.reduce((a, b) => (b.from > a.from ? b : a));
  const to = Math.min(...parts.map((part) => part.to));
  return last.from <= to && last.from >= 0 && last.from <= 1
    ? { share: last.from, normal: last.normal }
    : null;
}

function entry(g: Geometry, at: Vec3, way: Vec3): Entry | null | undefined {
  const point = (share: number): Vec3 => add(at, scale(way, share));
  switch (g.type) {
    case 'Box': {
      const half = scale(g.size ?? [2, 2, 2], 0.5);
      return common([0, 1, 2].map((axis) => slab(at, way, axis, -half[axis]!, half[axis]!)));
    }
    case 'Sphere': {
      const r = g.radius ?? 1;
      return common([quadric(dot(way, way), dot(at, way), dot(at, at) - r * r, point)]);
    }
    case 'Cylinder': {
      if (g.side === false || g.top === false || g.bottom === false) return undefined;
      const [r, h] = [g.radius ?? 1, (g.height ?? 2) / 2];
      const [p, d]: Vec3[] = [
        [at[0], 0, at[2]],
        [way[0], 0, way[2]],
      ];
      const side = quadric(dot(d!, d!), dot(p!, d!), dot(p!, p!) - r * r, (share) =>
        add(p!, scale(d!, share)),
      );
      return common([side, slab(at, way, 1, -h, h)]);
    }
    default:
      return undefined;
  }
}

/** Rows of the inverse of a 3 × 3 matrix, times its determinant. */
function cofactors(m: number[]): [Vec3, Vec3, Vec3] {
  const [x, y, z] = [0, 3, 6].map((row) => m.slice(row, row + 3) as Vec3) as [Vec3, Vec3, Vec3];
  return [cross(y, z), cross(z, x), cross(x, y)];
}

/**
 * The exact entry of a line into a box, sphere or cylinder, in the frame of its collidable; null where it misses,
 * undefined where the geometry has none of these forms.
 */
export function entryInto(g: Geometry, from: Vec3, to: Vec3): Entry | null | undefined {
  const m = g.linear ?? IDENTITY;
  const rows = cofactors(m);
  const determinant = dot(m.slice(0, 3) as Vec3, rows[0]);
  if (determinant === 0) return undefined;
  // The inverse has the cofactors as columns; it leaves shares of a line as they are.
  const back = (v: Vec3): Vec3 =>
    scale(
      add(add(scale(rows[0], v[0]), scale(rows[1], v[1])), scale(rows[2], v[2])),
      1 / determinant,
    );
  const [start, end] = [back(from), back(to)];
  const found = entry(g, start, subtract(end, start));
  if (!found) return found;
  // Normals go by the transposed inverse.
  const normal = rows.map((row) => dot(row, found.normal) / determinant) as Vec3;
  return { share: found.share, normal };
}
