import type { Faces } from '../../../shapes/forms/polytope.js';
import { boxOfPoints } from './points.js';
import { Convex, PARALLEL, TOUCH, type Flat } from './solid.js';

/** Numbers of an edge as one of its faces has it: its first end, the way to the other, and its outward normal in the face. */
const EDGE = 9;

/** A convex hull, by the planes of its faces and, for what rolls over them, by its edges. */
export class HullSolid extends Convex {
  readonly box: Flat;
  /** Of each face. */
  readonly #normals: Flat;
  readonly #heights: Flat;
  readonly #edges: Flat;
  /** Where the edges of each face begin, and the last one's end. */
  readonly #from: Int32Array;

  constructor({ points, faces, normals }: Faces) {
    super();
    this.box = boxOfPoints(points);
    this.#normals = normals;
    this.#heights = Float64Array.from(faces, (corners, face) => {
      let most = -Infinity;
      for (const corner of corners) most = Math.max(most, along(points, corner, normals, face));
      return most;
    });
    this.#from = new Int32Array(faces.length + 1);
    faces.forEach((corners, face) => {
      this.#from[face + 1] = this.#from[face]! + corners.length;
    });
    this.#edges = Float64Array.from(
      faces.flatMap((corners, face) =>
        corners.flatMap((corner, i) =>
          edge(points, corner, corners[(i + 1) % corners.length]!, normals, face),
        ),
      ),
    );
  }

  protected cut(way: Flat, out: Flat): boolean {
    const radius = way[6]!;
    const most = way[7]!;
    const normals = this.#normals;
    const heights = this.#heights;
    const x = way[0]!;
    const y = way[1]!;
    const z = way[2]!;
    const u = way[3]!;
    const v = way[4]!;
    const w = way[5]!;
    let enter = -Infinity;
    let exit = most;
    let entered = 0;
    for (let face = 0, at = 0; face < heights.length; face++, at += 3) {
      const a = normals[at]!;
      const b = normals[at + 1]!;
      const c = normals[at + 2]!;
      const over = a * x + b * y + c * z - heights[face]! - radius;
      const slope = a * u + b * v + c * w;
      if (Math.abs(slope) <= PARALLEL) {
        if (!(over <= TOUCH)) return false;
        continue;
      }
      const share = -over / slope;
      if (slope < 0) {
        if (share > enter) {
          enter = share;
          entered = face;
        }
      } else if (share < exit) exit = share;
      if (!(enter <= exit)) return false;
    }
    if (!(exit >= 0)) return false;
    out[0] = enter;
    for (let k = 0; k < 3; k++) out[1 + k] = normals[3 * entered + k]!;
    out[4] = 1;
    if (radius > TOUCH && enter > 0)
      out[4] = this.#lies(entered, x + u * enter, y + v * enter, z + w * enter) ? 1 : 0;
    return true;
  }

  /** Whether a point is above a face within its edges. */
  #lies(face: number, x: number, y: number, z: number): boolean {
    const edges = this.#edges;
    for (let i = this.#from[face]! * EDGE; i < this.#from[face + 1]! * EDGE; i += EDGE) {
      const out =
        (x - edges[i]!) * edges[i + 6]! +
        (y - edges[i + 1]!) * edges[i + 7]! +
        (z - edges[i + 2]!) * edges[i + 8]!;
      if (out > 0) return false;
    }
    return true;
  }

  gap(at: Flat, out: Flat): void {
    const x = at[0]!;
    const y = at[1]!;
    const z = at[2]!;
    const normals = this.#normals;
    const heights = this.#heights;
    let most = -Infinity;
    let nearest = 0;
    for (let face = 0, at = 0; face < heights.length; face++, at += 3) {
      const over = normals[at]! * x + normals[at + 1]! * y + normals[at + 2]! * z - heights[face]!;
      if (over > most) {
        most = over;
        nearest = face;
      }
    }
    for (let k = 0; k < 3; k++) out[k] = normals[3 * nearest + k]!;
    out[3] = most;
    if (most > TOUCH && !this.#lies(nearest, x, y, z)) this.#aside(x, y, z, out);
  }

  /** The same where it is not above the face that is farthest below it: of all that it is above, the nearest edge or face. */
  #aside(x: number, y: number, z: number, out: Flat): void {
    const normals = this.#normals;
    const heights = this.#heights;
    let least = Infinity;
    for (let face = 0, at = 0; face < heights.length; face++, at += 3) {
      const over = normals[at]! * x + normals[at + 1]! * y + normals[at + 2]! * z - heights[face]!;
      if (over < 0 || over * over >= least) continue;
      if (this.#lies(face, x, y, z)) {
        for (let k = 0; k < 3; k++) out[k] = normals[at + k]!;
        out[3] = over;
        return;
      }
      for (let i = this.#from[face]!; i < this.#from[face + 1]!; i++)
        least = Math.min(least, this.#toEdge(i * EDGE, x, y, z, least, out));
    }
    const distance = Math.sqrt(least);
    for (let k = 0; k < 3; k++) out[k]! /= distance;
    out[3] = distance;
  }

  /** The square of the distance from an edge; where it is less, the way from there goes to `out`. */
  #toEdge(i: number, x: number, y: number, z: number, least: number, out: Flat): number {
    const edges = this.#edges;
    const dx = edges[i + 3]!;
    const dy = edges[i + 4]!;
    const dz = edges[i + 5]!;
    let px = x - edges[i]!;
    let py = y - edges[i + 1]!;
    let pz = z - edges[i + 2]!;
    const size = dx * dx + dy * dy + dz * dz;
    const share = Math.max(0, Math.min(1, (px * dx + py * dy + pz * dz) / size));
    px -= dx * share;
    py -= dy * share;
    pz -= dz * share;
    const square = px * px + py * py + pz * pz;
    if (!(square < least)) return least;
    out[0] = px;
    out[1] = py;
    out[2] = pz;
    return square;
  }
}

const along = (points: Flat, corner: number, normals: Flat, face: number): number =>
  points[3 * corner]! * normals[3 * face]! +
  points[3 * corner + 1]! * normals[3 * face + 1]! +
  points[3 * corner + 2]! * normals[3 * face + 2]!;

function edge(points: Flat, from: number, to: number, normals: Flat, face: number): number[] {
  const start = [0, 1, 2].map((k) => points[3 * from + k]!);
  const way = start.map((value, k) => points[3 * to + k]! - value);
  const turn = [0, 1, 2].map((k) => {
    const i = (k + 1) % 3;
    const j = (k + 2) % 3;
    return way[i]! * normals[3 * face + j]! - way[j]! * normals[3 * face + i]!;
  });
  return [...start, ...way, ...turn];
}
