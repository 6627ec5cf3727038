import { cross, dot, length, scale, subtract } from '../../../base/math.js';
import type { Vec3 } from '../../../fields/types.js';
import { approach, begin, FOUND, write, type Distance, type Flat, type Solid } from './solid.js';
import { TriangleTree } from './triangle-tree.js';

/**
 * Triangles have no inside by which a point that lies on one would be known to be on its upper side: it is a ball of a
 * thousandth of a millimetre instead.
 */
export const SKIN = 1e-6;

/** What is so near to a triangle, metres, has no direction to it. */
const ON = 1e-15;

/** Numbers of a plane: its normal, and how far it is along that. */
const PLANE = 4;

/** Numbers of a triangle: its plane, and those that stand on its sides, outward. */
const PLANES = 4 * PLANE;

const one = new Float64Array(FOUND);

/** Triangles, a mesh or a height field: hollow and two-sided, as they are for bodies. */
export class SheetSolid implements Solid, Distance {
  readonly box: Flat;
  readonly #points: Flat;
  /** Without those that have no area. */
  readonly #index: Int32Array;
  readonly #planes: Flat;
  readonly #tree: TriangleTree;
  #triangle = 0;
  /** The side on which what lies within a triangle is taken to be. */
  #side = 1;

  /** `points`: x, y, z of each corner; `index`: three corners of each triangle. */
  constructor(points: ArrayLike<number>, index: ArrayLike<number>) {
    this.#points = Float64Array.from(points);
    const kept: number[] = [];
    const planes: number[] = [];
    for (let t = 0; t + 2 < index.length; t += 3) {
      const corners = [index[t]!, index[t + 1]!, index[t + 2]!];
      const own = planesOf(this.#points, corners);
      if (!own) continue;
      kept.push(...corners);
      planes.push(...own);
    }
    this.#index = Int32Array.from(kept);
    this.#planes = Float64Array.from(planes);
    this.#tree = new TriangleTree(this.#points, this.#index);
    this.box = this.#tree.box;
  }

  meets(way: Flat, found: Flat): boolean {
    const tree = this.#tree;
    if (way[6]! < SKIN) way[6] = SKIN;
    let depth = -1;
    tree.start(way);
    while (tree.next(way))
      for (let i = tree.from; i < tree.to; i++) {
        this.#triangle = tree.order[i]!;
        if (!this.#meetsOne(way)) continue;
        if (one[0]! === way[7]! && one[1]! <= depth) continue;
        for (let k = 0; k < FOUND; k++) found[k] = one[k]!;
        way[7] = one[0]!;
        depth = one[1]!;
      }
    return depth >= 0;
  }

  #meetsOne(way: Flat): boolean {
    const planes = this.#planes;
    const at = PLANES * this.#triangle;
    const a = planes[at]!;
    const b = planes[at + 1]!;
    const c = planes[at + 2]!;
    const height = a * way[0]! + b * way[1]! + c * way[2]! - planes[at + 3]!;
    const side = height < 0 ? -1 : 1;
    const slope = side * (a * way[3]! + b * way[4]! + c * way[5]!);
    const over = side * height - way[6]!;
    this.#side = height === 0 && slope > 0 ? -1 : side;
    if (over <= 0) {
      one[0] = 0;
      return !this.#passes(way) && begin(this, way, one);
    }
    if (!(slope < 0)) return false;
    const share = -over / slope;
    if (!(share <= way[7]!)) return false;
    const x = way[0]! + way[3]! * share;
    const y = way[1]! + way[4]! * share;
    const z = way[2]! + way[5]! * share;
    const aside = this.#aside(x, y, z);
    if (aside <= 0) return write(one, share, 0, side * a, side * b, side * c);
    one[0] = share;
    return !this.#passes(way) && approach(this, way, one);
  }

  /** Whether a way, from the share `one[0]` on, is too far beyond one side of the triangle all along. */
  #passes(way: Flat): boolean {
    const planes = this.#planes;
    const ball = way[6]!;
    const first = PLANES * this.#triangle + PLANE;
    for (let at = first; at < first + 3 * PLANE; at += PLANE) {
      const a = planes[at]!;
      const b = planes[at + 1]!;
      const c = planes[at + 2]!;
      const away = a * way[0]! + b * way[1]! + c * way[2]! - planes[at + 3]! - ball;
      const slope = a * way[3]! + b * way[4]! + c * way[5]!;
      if (away + slope * one[0]! > 0 && away + slope * way[7]! > 0) return true;
    }
    return false;
  }

  /** How far a point is beyond the sides of the triangle, as seen along its normal; below 0 within. */
  #aside(x: number, y: number, z: number): number {
    const planes = this.#planes;
    const at = PLANES * this.#triangle + PLANE;
    const a = planes[at]! * x + planes[at + 1]! * y + planes[at + 2]! * z - planes[at + 3]!;
    const b = planes[at + 4]! * x + planes[at + 5]! * y + planes[at + 6]! * z - planes[at + 7]!;
    const c = planes[at + 8]! * x + planes[at + 9]! * y + planes[at + 10]! * z - planes[at + 11]!;
    return a > b ? (a > c ? a : c) : b > c ? b : c;
  }

  /** From the triangle that is looked at; never below 0. */
  gap(at: Flat, out: Flat): void {
    const planes = this.#planes;
    const t = PLANES * this.#triangle;
    if (this.#aside(at[0]!, at[1]!, at[2]!) <= 0) {
      const height =
        planes[t]! * at[0]! + planes[t + 1]! * at[1]! + planes[t + 2]! * at[2]! - planes[t + 3]!;
      const side = height === 0 ? this.#side : height < 0 ? -1 : 1;
      for (let k = 0; k < 3; k++) out[k] = side * planes[t + k]!;
      out[3] = side * height;
      return;
    }
    out[3] = Infinity;
    for (let i = 0; i < 3; i++) this.#toSide(i, at, out);
    const distance = Math.sqrt(out[3]);
    out[3] = distance;
    if (distance <= ON) for (let k = 0; k < 3; k++) out[k] = this.#side * planes[t + k]!;
    else for (let k = 0; k < 3; k++) out[k]! /= distance;
  }

  /** Where a side is nearer than what `out` has: the way from there, and the square of the distance. */
  #toSide(side: number, at: Flat, out: Flat): void {
    const points = this.#points;
    const t = 3 * this.#triangle;
    const from = 3 * this.#index[t + side]!;
    const to = 3 * this.#index[t + (side === 2 ? 0 : side + 1)]!;
    const u = points[to]! - points[from]!;
    const v = points[to + 1]! - points[from + 1]!;
    const w = points[to + 2]! - points[from + 2]!;
    let x = at[0]! - points[from]!;
    let y = at[1]! - points[from + 1]!;
    let z = at[2]! - points[from + 2]!;
    const share = Math.max(0, Math.min(1, (x * u + y * v + z * w) / (u * u + v * v + w * w)));
    x -= u * share;
    y -= v * share;
    z -= w * share;
    const square = x * x + y * y + z * z;
    if (!(square < out[3]!)) return;
    out[0] = x;
    out[1] = y;
    out[2] = z;
    out[3] = square;
  }
}

/** Against the clock; undefined where it has no area. */
function planesOf(points: Flat, corners: readonly number[]): number[] | undefined {
  const at = corners.map((corner): Vec3 => [
    points[3 * corner]!,
    points[3 * corner + 1]!,
    points[3 * corner + 2]!,
  ]) as [Vec3, Vec3, Vec3];
  const turn = cross(subtract(at[1], at[0]), subtract(at[2], at[0]));
  const area = length(turn);
  if (!(area > 0)) return undefined;
  const normal = scale(turn, 1 / area);
  const sides = at.flatMap((corner, i) => {
    const out = cross(subtract(at[(i + 1) % 3]!, corner), normal);
    const unit = scale(out, 1 / length(out));
    return [...unit, dot(unit, corner)];
  });
  return [...normal, dot(normal, at[0]), ...sides];
}
