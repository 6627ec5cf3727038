import type { Ammo } from './ammo.js';
import { BODY, MANIFOLD, MANIFOLD_POINT as POINT } from './offsets.js';
import type { OldPoints } from './old-points.js';

/** Points to be written. */
export interface NewPoints {
  /** The numbers of those that are to be written, and how many. */
  readonly kept: Int32Array;
  readonly keptCount: number;
  /** Of each: where it lies on B, the unit normal from B into A, and the distance, metres. */
  readonly at: Float64Array;
  readonly normal: Float64Array;
  readonly distance: Float64Array;
  /** The number of the triangle that it lies on, or -1. */
  readonly triangle: Int32Array;
  /** Whose corner it is: `CORNER`. */
  readonly corner: Int8Array;
}

/** Of a part that is no triangle, as Bullet numbers it. */
const NO_TRIANGLE = -1;

/** Puts points that were found into a manifold of Bullet's, with the impulses of those that were there. */
export class ManifoldWriter {
  readonly #ammo: Ammo;
  readonly #old: OldPoints;

  readonly #friction: number;

  /** `friction`: of points that were not there before. */
  constructor(ammo: Ammo, old: OldPoints, friction: number) {
    this.#ammo = ammo;
    this.#old = old;
    this.#friction = friction;
  }

  /** `partA`, `partB`: their numbers among the parts of the bodies; `meshSide`: the side that triangles are of, 0 for A. */
  write(
    manifold: number,
    a: number,
    b: number,
    points: NewPoints,
    partA: number,
    partB: number,
    meshSide: 0 | 1 = 1,
  ): void {
    for (let i = 0; i < points.keptCount; i++) {
      const point = manifold + MANIFOLD.points + i * POINT.size;
      const number = points.kept[i]!;
      this.#writePoint(point, a, b, points, number);
      const triangle = points.triangle[number]!;
      this.#writePart(point, 0, partA, meshSide === 0 ? triangle : NO_TRIANGLE);
      this.#writePart(point, 1, partB, meshSide === 1 ? triangle : NO_TRIANGLE);
    }
    this.#ammo.HEAP32[(manifold + MANIFOLD.pointCount) >> 2] = points.keptCount;
  }

  #writePart(point: number, side: 0 | 1, part: number, triangle: number): void {
    const { HEAP32 } = this.#ammo;
    const isTriangle = triangle !== NO_TRIANGLE;
    HEAP32[(point + (side === 0 ? POINT.part0 : POINT.part1)) >> 2] = isTriangle ? 0 : -1;
    HEAP32[(point + (side === 0 ? POINT.index0 : POINT.index1)) >> 2] = isTriangle
      ? triangle
      : part;
  }

  #writePoint(point: number, a: number, b: number, points: NewPoints, number: number): void {
    const { at, normal } = points;
    const from = 3 * number;
    const x = at[from]!;
    const y = at[from + 1]!;
    const z = at[from + 2]!;
    const nx = normal[from]!;
    const ny = normal[from + 1]!;
    const nz = normal[from + 2]!;
    const distance = points.distance[number]!;
    this.#old.take(point, x, y, z, nx, ny, nz);
    const { HEAPF32, HEAP32 } = this.#ammo;
    // What an author says of the surfaces is written anew by who knows of it.
    HEAPF32[(point + POINT.friction) >> 2] = this.#friction;
    HEAPF32[(point + POINT.rollingFriction) >> 2] = 0;
    HEAPF32[(point + POINT.restitution) >> 2] = 0;
    HEAP32[(point + POINT.directionsGiven) >> 2] = 0;
    HEAP32[(point + POINT.corner) >> 2] = points.corner[number]!;
    this.#put(point + POINT.positionB, x, y, z);
    this.#put(point + POINT.positionA, x + nx * distance, y + ny * distance, z + nz * distance);
    this.#put(point + POINT.normalB, nx, ny, nz);
    HEAPF32[(point + POINT.distance) >> 2] = distance;
    this.#putLocal(point + POINT.localA, point + POINT.positionA, a);
    this.#putLocal(point + POINT.localB, point + POINT.positionB, b);
  }

  #put(to: number, x: number, y: number, z: number): void {
    const { HEAPF32 } = this.#ammo;
    const at = to >> 2;
    HEAPF32[at] = x;
    HEAPF32[at + 1] = y;
    HEAPF32[at + 2] = z;
  }

  /** A place of the world in the frame of a body. */
  #putLocal(to: number, from: number, body: number): void {
    const { HEAPF32 } = this.#ammo;
    const origin = (body + BODY.origin) >> 2;
    const rows = (body + BODY.basis) >> 2;
    const x = HEAPF32[from >> 2]! - HEAPF32[origin]!;
    const y = HEAPF32[(from >> 2) + 1]! - HEAPF32[origin + 1]!;
    const z = HEAPF32[(from >> 2) + 2]! - HEAPF32[origin + 2]!;
    for (let i = 0; i < 3; i++)
      HEAPF32[(to >> 2) + i] =
        x * HEAPF32[rows + i]! + y * HEAPF32[rows + 4 + i]! + z * HEAPF32[rows + 8 + i]!;
  }
}
