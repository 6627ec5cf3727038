import { TRIANGLE, type Box } from './triangles.js';

/** Cells along each side of a mesh's box. */
export const CELLS = 24;

/** Of a cell: what rounding may leave between a triangle and where it ends. */
export const MARGIN = 1e-6;

/** Which cells of an axis, as the first and the last, a triangle reaches. */
export function reachOf(
  triangles: Float64Array,
  at: number,
  k: number,
  box: Box,
): [number, number] {
  const ends = [0, 3, 6].map(
    (corner) => ((triangles[at + corner + k]! - box.least[k]!) / box.sides[k]!) * CELLS,
  );
  const inBox = (cell: number): number => Math.min(Math.max(Math.floor(cell), 0), CELLS - 1);
  return [inBox(Math.min(...ends) - MARGIN), inBox(Math.max(...ends) + MARGIN)];
}

/** The triangles of a closed mesh by the column of cells, upright along z, in which a ray may meet them. */
export class Columns {
  readonly #triangles: Float64Array;
  readonly #oriented: boolean;
  /** Where the list of each column begins. */
  readonly #from = new Int32Array(CELLS * CELLS + 1);
  readonly #list: Int32Array;

  constructor(triangles: Float64Array, oriented: boolean, box: Box) {
    this.#triangles = triangles;
    this.#oriented = oriented;
    const lists = Array.from({ length: CELLS * CELLS }, (): number[] => []);
    for (let at = 0; at < triangles.length; at += TRIANGLE) {
      const [west, east] = reachOf(triangles, at, 0, box);
      const [south, north] = reachOf(triangles, at, 1, box);
      for (let x = west; x <= east; x++)
        for (let y = south; y <= north; y++)
          if (isOver(triangles, at, box, x, y)) lists[x * CELLS + y]!.push(at);
    }
    lists.forEach((list, i) => (this.#from[i + 1] = this.#from[i]! + list.length));
    this.#list = Int32Array.from(lists.flat());
  }

  /**
   * Whether a place is inside: a ray upwards meets an odd number of triangles. Where they agree on what is outside, it leaves
   * through more or fewer than it comes in by: so parts that overlap are all inside, and so is none of a hollow.
   */
  holds(column: number, x: number, y: number, z: number): boolean {
    let met = 0;
    let turns = 0;
    for (let i = this.#from[column]!; i < this.#from[column + 1]!; i++) {
      const at = this.#list[i]!;
      if (!isUnder(this.#triangles, at, x, y)) continue;
      const sense = senseAbove(this.#triangles, at, x, y, z);
      if (sense === 0) continue;
      met++;
      turns += sense;
    }
    return this.#oriented ? turns !== 0 : met % 2 === 1;
  }
}

/** Whether no side of a triangle, seen along z, has all of a column beyond it. */
function isOver(t: Float64Array, at: number, box: Box, column: number, row: number): boolean {
  const halfX = box.sides[0] / CELLS / 2;
  const halfY = box.sides[1] / CELLS / 2;
  const x = box.least[0] + (2 * column + 1) * halfX;
  const y = box.least[1] + (2 * row + 1) * halfY;
  const area = across(t, at, at + 3, t[at + 6]!, t[at + 7]!);
  for (let i = 0; i < 3; i++) {
    const a = at + 3 * i;
    const b = at + 3 * ((i + 1) % 3);
    const reach = Math.abs(t[b]! - t[a]!) * halfY + Math.abs(t[b + 1]! - t[a + 1]!) * halfX;
    if (Math.sign(area) * across(t, a, b, x, y) < -reach * (1 + MARGIN)) return false;
  }
  return area !== 0;
}

/** Twice the area that a side has with a point, seen along z; above 0 on the side's left. */
const across = (t: Float64Array, a: number, b: number, x: number, y: number): number =>
  (t[b]! - t[a]!) * (y - t[a + 1]!) - (t[b + 1]! - t[a + 1]!) * (x - t[a]!);

/** Whether the ray's line goes through a triangle, seen along it. */
function isUnder(t: Float64Array, at: number, x: number, y: number): boolean {
  const ab = isPassed(t, at, at + 3, x, y);
  const bc = isPassed(t, at + 3, at + 6, x, y);
  const ca = isPassed(t, at + 6, at, x, y);
  return (ab !== bc) !== ca;
}

/** Whether a side passes a point on the right. It is looked at from its lower end, so that both its triangles agree. */
function isPassed(t: Float64Array, a: number, b: number, x: number, y: number): boolean {
  if (t[a + 1]! > y === t[b + 1]! > y) return false;
  const low = t[a + 1]! < t[b + 1]! ? a : b;
  const high = low === a ? b : a;
  const way = (t[high]! - t[low]!) * (y - t[low + 1]!);
  return (t[high + 1]! - t[low + 1]!) * (x - t[low]!) < way;
}

/** 0 where the ray's line meets a triangle below; above, 1 where it goes out there, and -1 where it comes in. */
function senseAbove(t: Float64Array, at: number, x: number, y: number, z: number): number {
  const abx = t[at + 3]! - t[at]!;
  const aby = t[at + 4]! - t[at + 1]!;
  const abz = t[at + 5]! - t[at + 2]!;
  const acx = t[at + 6]! - t[at]!;
  const acy = t[at + 7]! - t[at + 1]!;
  const acz = t[at + 8]! - t[at + 2]!;
  const nz = abx * acy - aby * acx;
  const slope = (aby * acz - abz * acy) * (x - t[at]!) + (abz * acx - abx * acz) * (y - t[at + 1]!);
  // The plane stands above where n · (place - a) is against n's own sense.
  const beyond = slope + nz * (z - t[at + 2]!);
  if (nz > 0) return beyond < 0 ? 1 : 0;
  return beyond > 0 ? -1 : 0;
}
