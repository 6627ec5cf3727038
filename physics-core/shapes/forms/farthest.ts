import { hypot } from '../../base/exact/index.js';
import type { Flat } from './form.js';

/** Cells along one edge of the cube that directions are sorted by: with 5, a twelfth of what lies on a ball is left in each; with more, finding that out takes longer (measured). */
const CELLS = 5;

/** So few are looked at one by one. */
const FEW = 12;

/** What rounding may make of two directions, or of two heights: a share of their size. */
const ROUNDING = 1e-9;

/**
 * Which of many points is farthest along a direction, of equals the first. Directions are sorted into cells, and of each
 * cell only those points are looked at that are farthest somewhere in it: the answer is the one that all would give.
 */
export class Farthest {
  readonly #points: Flat;
  readonly #all: Int32Array;
  /** By cell, from when a direction first falls into it: where the points begin that are farthest somewhere in it. */
  readonly #near: (Int32Array | undefined)[] = [];

  /** `points`: three numbers each. */
  constructor(points: Flat) {
    this.#points = points;
    this.#all = Int32Array.from({ length: points.length / 3 }, (_, i) => 3 * i);
  }

  /** The number of a point. */
  along(x: number, y: number, z: number): number {
    const points = this.#points;
    const near = this.#all.length > FEW ? this.#nearOf(x, y, z) : this.#all;
    let most = -Infinity;
    let found = 0;
    for (let k = 0; k < near.length; k++) {
      const i = near[k]!;
      const along = points[i]! * x + points[i + 1]! * y + points[i + 2]! * z;
      if (along > most) {
        most = along;
        found = i;
      }
    }
    return found / 3;
  }

  #nearOf(x: number, y: number, z: number): Int32Array {
    const u = Math.abs(x);
    const v = Math.abs(y);
    const w = Math.abs(z);
    const cell =
      u >= v && u >= w
        ? cellOf(x < 0 ? 0 : 1, y / u, z / u)
        : v >= w
          ? cellOf(y < 0 ? 2 : 3, z / v, x / v)
          : cellOf(z < 0 ? 4 : 5, x / w, y / w);
    return (this.#near[cell] ??= this.#look(cell));
  }

  #look(cell: number): Int32Array {
    const side = Math.floor(cell / CELLS ** 2);
    const row = Math.floor(cell / CELLS) % CELLS;
    const column = cell % CELLS;
    const [x, y, z] = directionAt(side, row + 0.5, column + 0.5);
    let far = 0;
    for (const end of [0, 1])
      for (const other of [0, 1]) {
        const [a, b, c] = directionAt(side, row + end, column + other);
        far = Math.max(far, hypot(a - x, b - y, c - z));
      }
    return this.#farthestWithin(x, y, z, far + ROUNDING);
  }

  /** In no direction at most so `far` from this one is a point farthest that lies lower by more than that lifts it. */
  #farthestWithin(x: number, y: number, z: number, far: number): Int32Array {
    const points = this.#points;
    const all = this.#all;
    const heights = new Float64Array(all.length);
    let best = 0;
    for (let k = 0; k < all.length; k++) {
      const i = 3 * k;
      heights[k] = points[i]! * x + points[i + 1]! * y + points[i + 2]! * z;
      if (heights[k]! > heights[best]!) best = k;
    }
    const u = points[3 * best]!;
    const v = points[3 * best + 1]!;
    const w = points[3 * best + 2]!;
    const least = heights[best]! - ROUNDING * (Math.abs(u) + Math.abs(v) + Math.abs(w));
    let count = 0;
    const found = new Int32Array(all.length);
    for (let k = 0; k < all.length; k++) {
      const i = 3 * k;
      const p = points[i]! - u;
      const q = points[i + 1]! - v;
      const r = points[i + 2]! - w;
      const short = least - heights[k]!;
      if (short <= 0 || short * short <= far * far * (p * p + q * q + r * r)) found[count++] = i;
    }
    return found.slice(0, count);
  }
}

/** The cell of a side of the cube in which two numbers from -1 to 1 lie; any, where they are none. */
function cellOf(side: number, row: number, column: number): number {
  const i = Math.min(CELLS - 1, (0.5 * CELLS * (row + 1)) | 0);
  const j = Math.min(CELLS - 1, (0.5 * CELLS * (column + 1)) | 0);
  return (side * CELLS + i) * CELLS + j;
}

/** The unit vector to a place on a side of the cube, by rows and columns of its cells. */
function directionAt(side: number, row: number, column: number): readonly [number, number, number] {
  const u = (2 * row) / CELLS - 1;
  const v = (2 * column) / CELLS - 1;
  const size = hypot(1, u, v);
  const out = (side % 2 === 0 ? -1 : 1) / size;
  const a = u / size;
  const b = v / size;
  if (side < 2) return [out, a, b];
  return side < 4 ? [b, out, a] : [a, b, out];
}
