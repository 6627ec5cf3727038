import { BELOW, PLANE, type Cuttable, type Flat } from './cut.js';

/** Of the corners of what is left of a triangle, from a point of the plane: four at most, x y z. */
const corners = new Float64Array(12);

/**
 * What is bounded by triangles that are all turned outward. Seen from a point of the plane what lies below it is made of
 * tetrahedra, one on each piece of its skin; the one on the plane has no volume, so the cut itself need not be found.
 */
export class FacetCut implements Cuttable {
  readonly #points: Flat;
  readonly #index: Int32Array;
  /** How far each point is above the plane. */
  readonly #heights: Flat;

  /** Points are flat, x y z; of each triangle the numbers of its corners, one after the other. */
  constructor(points: ArrayLike<number>, index: ArrayLike<number>) {
    this.#points = Float64Array.from(points);
    this.#index = Int32Array.from(index);
    this.#heights = new Float64Array(points.length / 3);
  }

  below(plane: Flat, out: Flat): void {
    out.fill(0, 0, BELOW.area + 1);
    this.#measure(plane);
    const index = this.#index;
    for (let i = 0; i < index.length; i += 3)
      addFan(this.#clip(plane, index[i]!, index[i + 1]!, index[i + 2]!), plane, out);
    const offset = plane[PLANE.offset]!;
    for (let k = 0; k < 3; k++)
      out[BELOW.moment + k] =
        out[BELOW.moment + k]! + out[BELOW.volume]! * offset * plane[PLANE.normal + k]!;
  }

  #measure(plane: Flat): void {
    const points = this.#points;
    const heights = this.#heights;
    for (let i = 0, at = 0; i < heights.length; i++, at += 3)
      heights[i] =
        plane[0]! * points[at]! +
        plane[1]! * points[at + 1]! +
        plane[2]! * points[at + 2]! -
        plane[PLANE.offset]!;
  }

  /** Writes what is left of a triangle below the plane; how many corners that has. */
  #clip(plane: Flat, a: number, b: number, c: number): number {
    let count = this.#edge(plane, a, b, 0);
    count = this.#edge(plane, b, c, count);
    return this.#edge(plane, c, a, count);
  }

  /** The start of an edge, where that is below, and where the edge goes through the plane. */
  #edge(plane: Flat, from: number, to: number, count: number): number {
    const start = this.#heights[from]!;
    const end = this.#heights[to]!;
    let next = count;
    if (start < 0) this.#corner(plane, from, from, 0, next++);
    if (start < 0 !== end < 0) this.#corner(plane, from, to, start / (start - end), next++);
    return next;
  }

  #corner(plane: Flat, from: number, to: number, share: number, corner: number): void {
    const points = this.#points;
    for (let k = 0; k < 3; k++) {
      const start = points[3 * from + k]!;
      corners[3 * corner + k] =
        start +
        share * (points[3 * to + k]! - start) -
        plane[PLANE.offset]! * plane[PLANE.normal + k]!;
    }
  }
}

/** Adds the tetrahedra on triangles of a piece of skin, all of which begin at its first corner. */
function addFan(count: number, plane: Flat, out: Flat): void {
  for (let i = 1; i + 1 < count; i++) addTetrahedron(3 * i, plane, out);
}

function addTetrahedron(at: number, plane: Flat, out: Flat): void {
  let volume = 0;
  let area = 0;
  for (let k = 0; k < 3; k++) {
    const j = (k + 1) % 3;
    const l = (k + 2) % 3;
    const b = at;
    const c = at + 3;
    volume +=
      (corners[k]! * (corners[b + j]! * corners[c + l]! - corners[b + l]! * corners[c + j]!)) / 6;
    const u = (corners[b + j]! - corners[j]!) * (corners[c + l]! - corners[l]!);
    const v = (corners[b + l]! - corners[l]!) * (corners[c + j]! - corners[j]!);
    area += (plane[PLANE.normal + k]! * (u - v)) / 2;
  }
  out[BELOW.volume] = out[BELOW.volume]! + volume;
  // What the skin lacks to be closed is in the plane.
  out[BELOW.area] = out[BELOW.area]! - area;
  for (let k = 0; k < 3; k++)
    out[BELOW.moment + k] =
      out[BELOW.moment + k]! +
      (volume * (corners[k]! + corners[at + k]! + corners[at + 3 + k]!)) / 4;
}
