import { cross3, dot3 } from '../../base/flat-math.js';
import type { Flat } from '../../shapes/cut/cut.js';

/** Numbers of a triangle: its normal, its area and its middle. */
const FACET = 7;
const AREA = 3;
const MIDDLE = 4;

/** Corners of what is left of a triangle between two planes: five at most, and before and after each cut. */
const ROOM = 3 * 6;
let corners = new Float64Array(ROOM);
let cut = new Float64Array(ROOM);
const u = new Float64Array(3);
const v = new Float64Array(3);
const w = new Float64Array(3);
/** A piece's normal and middle. */
const piece = new Float64Array(6);

/** What sees each piece of a skin: its area, m², and in `numbers` from `normal` and `middle` on what else there is to it. */
export type SeePiece = (area: number, numbers: Flat, normal: number, middle: number) => void;

/** The skin of a body as water sees it: flat pieces, in the frame of the centre of mass. */
export class Skin {
  readonly #points: Flat;
  /** Of each triangle the numbers of its corners. */
  readonly #index: Int32Array;
  readonly #facets: Flat;
  /** How far each point is above the planes. */
  readonly #heights: Flat;
  readonly #overFloor: Flat;
  /** m². */
  area = 0;

  /** Corners of triangles, x y z. */
  constructor(triangles: ArrayLike<number>) {
    const { points, index } = shared(triangles);
    this.#points = points;
    this.#index = index;
    this.#facets = new Float64Array((FACET * index.length) / 3);
    this.#heights = new Float64Array(points.length / 3);
    this.#overFloor = new Float64Array(points.length / 3);
    for (let i = 0; 3 * i < index.length; i++) this.#take(triangles, 9 * i, FACET * i);
  }

  #take(triangles: ArrayLike<number>, from: number, at: number): void {
    const f = this.#facets;
    for (let k = 0; k < 3; k++) {
      const corner = triangles[from + k]!;
      u[k] = triangles[from + 3 + k]! - corner;
      v[k] = triangles[from + 6 + k]! - corner;
      f[at + MIDDLE + k] = corner + (u[k]! + v[k]!) / 3;
    }
    cross3(w, 0, u, 0, v, 0);
    const twice = Math.sqrt(dot3(w, 0, w, 0));
    f[at + AREA] = twice / 2;
    this.area += twice / 2;
    for (let k = 0; k < 3; k++) f[at + k] = twice > 0 ? w[k]! / twice : 0;
  }

  /** How far a corner of it reaches along a unit vector, or against it where `sign` is -1, metres. */
  farthest(way: Flat, sign: number): number {
    let most = -Infinity;
    for (let at = 0; at < this.#points.length; at += 3)
      most = Math.max(most, sign * dot3(way, 0, this.#points, at));
    return most;
  }

  /** The area that is seen of it along a unit vector, m²: both sides of what is closed show the same. */
  seenAlong(way: Flat): number {
    const f = this.#facets;
    let both = 0;
    for (let at = 0; at < f.length; at += FACET)
      both += f[at + AREA]! * Math.abs(dot3(way, 0, f, at));
    return both / 2;
  }

  /** Shows each piece that lies below a plane, and above another one if there is one. */
  below(plane: Flat, floor: Flat | undefined, see: SeePiece): void {
    const index = this.#index;
    const heights = this.#heights;
    const over = this.#overFloor;
    this.#measure(plane, heights);
    if (floor) this.#measure(floor, over);
    for (let i = 0, at = 0; i < index.length; i += 3, at += FACET) {
      const a = index[i]!;
      const b = index[i + 1]!;
      const c = index[i + 2]!;
      const under = +(heights[a]! < 0) + +(heights[b]! < 0) + +(heights[c]! < 0);
      if (under === 0) continue;
      const inside = floor ? +(over[a]! >= 0) + +(over[b]! >= 0) + +(over[c]! >= 0) : 3;
      if (inside === 0) continue;
      if (under === 3 && inside === 3) see(this.#facets[at + AREA]!, this.#facets, at, at + MIDDLE);
      else this.#seePart(i, at, plane, inside < 3 ? floor : undefined, see);
    }
  }

  #measure(plane: Flat, heights: Flat): void {
    const p = this.#points;
    for (let i = 0, at = 0; at < p.length; i++, at += 3)
      heights[i] = plane[0]! * p[at]! + plane[1]! * p[at + 1]! + plane[2]! * p[at + 2]! - plane[3]!;
  }

  #seePart(first: number, at: number, plane: Flat, floor: Flat | undefined, see: SeePiece): void {
    const f = this.#facets;
    for (let corner = 0; corner < 3; corner++)
      for (let k = 0; k < 3; k++)
        corners[3 * corner + k] = this.#points[3 * this.#index[first + corner]! + k]!;
    let count = clip(3, plane, 1);
    if (floor) count = clip(count, floor, -1);
    let whole = 0;
    for (let k = 0; k < 3; k++) {
      piece[k] = f[at + k]!;
      piece[3 + k] = 0;
    }
    for (let i = 1; i + 1 < count; i++) {
      for (let k = 0; k < 3; k++) {
        u[k] = corners[3 * i + k]! - corners[k]!;
        v[k] = corners[3 * i + 3 + k]! - corners[k]!;
      }
      cross3(w, 0, u, 0, v, 0);
      const area = dot3(w, 0, piece, 0) / 2;
      whole += area;
      for (let k = 0; k < 3; k++) {
        const middle = (corners[k]! + corners[3 * i + k]! + corners[3 * i + 3 + k]!) / 3;
        piece[3 + k] = piece[3 + k]! + area * middle;
      }
    }
    if (!(whole > 0)) return;
    for (let k = 3; k < 6; k++) piece[k] = piece[k]! / whole;
    see(whole, piece, 0, 3);
  }
}

/** Leaves of `corners` what lies below a plane, or above it where `side` is -1; how many corners that has. */
function clip(count: number, plane: Flat, side: number): number {
  let left = 0;
  for (let from = 0; from < count; from++) {
    const to = from + 1 < count ? from + 1 : 0;
    const start = side * (dot3(plane, 0, corners, 3 * from) - plane[3]!);
    const end = side * (dot3(plane, 0, corners, 3 * to) - plane[3]!);
    if (start < 0) addCorner(left++, from, from, 0);
    if (start < 0 !== end < 0) addCorner(left++, from, to, start / (start - end));
  }
  const before = corners;
  corners = cut;
  cut = before;
  return left;
}

function addCorner(number: number, from: number, to: number, share: number): void {
  for (let k = 0; k < 3; k++) {
    const start = corners[3 * from + k]!;
    cut[3 * number + k] = start + share * (corners[3 * to + k]! - start);
  }
}

/** Triangles that share their corners. */
function shared(triangles: ArrayLike<number>): { points: Flat; index: Int32Array } {
  const numbers = new Map<string, number>();
  const points: number[] = [];
  const index = new Int32Array(triangles.length / 3);
  for (let corner = 0; corner < index.length; corner++) {
    const at = 3 * corner;
    const place = `${triangles[at]} ${triangles[at + 1]} ${triangles[at + 2]}`;
    let number = numbers.get(place);
    if (number === undefined) {
      numbers.set(place, (number = numbers.size));
      points.push(triangles[at]!, triangles[at + 1]!, triangles[at + 2]!);
    }
    index[corner] = number;
  }
  return { points: Float64Array.from(points), index };
}
