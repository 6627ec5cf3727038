import { hypot } from '../../base/exact/index.js';
import { Farthest } from './farthest.js';
import type { Flat, Form } from './form.js';

/** Within this angle from it, in radians, an edge lies along a plane. */
const ALONG = 0.02;

/** Flat faces that bound something convex. */
export interface Faces {
  /** Corners. */
  readonly points: Flat;
  /** The corners of each face in order, against the clock as seen from outside. */
  readonly faces: readonly (readonly number[])[];
  /** Their outward normals. */
  readonly normals: Flat;
}

/** What is bounded by flat faces: a convex hull, a triangle. */
export class PolytopeForm implements Form {
  readonly round = 0;
  readonly cornered = true;
  readonly reach: number;
  readonly points: Flat;
  readonly #faces: Faces['faces'];
  readonly #normals: Flat;
  /** From when they are asked for first. */
  #farthestCorner: Farthest | undefined;
  #farthestNormal: Farthest | undefined;
  /** From each corner along the edges to others. */
  readonly #neighbours: readonly (readonly number[])[];

  constructor(
    { points, faces, normals }: Faces,
    neighbours = neighboursOf(points.length / 3, faces),
  ) {
    this.points = points;
    this.#faces = faces;
    this.#normals = normals;
    this.#neighbours = neighbours;
    let reach = 0;
    for (let i = 0; i < points.length; i += 3)
      reach = Math.max(reach, hypot(points[i]!, points[i + 1]!, points[i + 2]!));
    this.reach = reach;
  }

  /** The number of the corner that is farthest along a direction, of equals the first. */
  protected farthest(x: number, y: number, z: number): number {
    return (this.#farthestCorner ??= new Farthest(this.points)).along(x, y, z);
  }

  #copy(corner: number, out: Flat, at: number): void {
    const { points } = this;
    const from = 3 * corner;
    out[at] = points[from]!;
    out[at + 1] = points[from + 1]!;
    out[at + 2] = points[from + 2]!;
  }

  support(direction: Flat, out: Flat): void {
    this.#copy(this.farthest(direction[0]!, direction[1]!, direction[2]!), out, 0);
  }

  /** The number of the face that looks most along a direction, of equals the first. */
  protected mostAlong(x: number, y: number, z: number): number {
    return (this.#farthestNormal ??= new Farthest(this.#normals)).along(x, y, z);
  }

  facing(x: number, y: number, z: number, out: Flat): number {
    const number = this.mostAlong(x, y, z);
    for (let i = 0; i < 3; i++) out[i] = this.#normals[3 * number + i]!;
    return number;
  }

  face(number: number, out: Flat): number {
    const corners = this.#faces[number]!;
    for (let i = 0; i < corners.length; i++) this.#copy(corners[i]!, out, 3 * i);
    return corners.length;
  }

  lying(x: number, y: number, z: number, _u: number, _v: number, _w: number, out: Flat): number {
    return this.face(this.mostAlong(x, y, z), out);
  }

  line(x: number, y: number, z: number, out: Flat): number {
    const { points } = this;
    const corner = this.farthest(x, y, z);
    this.#copy(corner, out, 0);
    let least = ALONG;
    let found = -1;
    for (const next of this.#neighbours[corner]!) {
      const dx = points[3 * next]! - out[0]!;
      const dy = points[3 * next + 1]! - out[1]!;
      const dz = points[3 * next + 2]! - out[2]!;
      const sine = Math.abs(x * dx + y * dy + z * dz) / Math.sqrt(dx * dx + dy * dy + dz * dz);
      if (sine < least) {
        least = sine;
        found = next;
      }
    }
    if (found < 0) return 1;
    this.#copy(found, out, 3);
    return 2;
  }
}

/** Of each corner those that a side leads to. */
export function neighboursOf(count: number, faces: readonly (readonly number[])[]): number[][] {
  const found = Array.from({ length: count }, () => new Set<number>());
  for (const corners of faces)
    corners.forEach((corner, i) => {
      const next = corners[(i + 1) % corners.length]!;
      found[corner]!.add(next);
      found[next]!.add(corner);
    });
  return found.map((each) => [...each]);
}
