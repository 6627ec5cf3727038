import { boxOf, TRIANGLE } from './triangles.js';

/** Corners nearer to each other than this share of the mesh's size are one: a sphere's seam and poles meet but for rounding. */
const SAME = 2 ** -16;

/** How triangles hang together. */
export interface Closed {
  /** Every side is one of an even number of triangles: a ray from within leaves through an odd number of them. */
  closed: boolean;
  /** Those go along it as often one way as the other: outside and inside of all triangles agree. */
  oriented: boolean;
}

/** Corners are told apart by where they are, since faces often have points of their own. */
export function closedOf(triangles: Float64Array): Closed {
  const corners = cornersByPlace(triangles);
  const odd = new Set<number>();
  const turns = new Map<number, number>();
  corners.forEach((from, i) => {
    const to = corners[i % 3 === 2 ? i - 2 : i + 1]!;
    if (from === to) return;
    const side = Math.min(from, to) * corners.length + Math.max(from, to);
    if (!odd.delete(side)) odd.add(side);
    turns.set(side, (turns.get(side) ?? 0) + (from < to ? 1 : -1));
  });
  const closed = triangles.length > 0 && odd.size === 0;
  return { closed, oriented: closed && [...turns.values()].every((sum) => sum === 0) };
}

/** Of each corner the number of its place. */
function cornersByPlace(triangles: Float64Array): Int32Array {
  const places = new Map<number, number>();
  const cells = cellsOf(triangles);
  return Int32Array.from({ length: (triangles.length / TRIANGLE) * 3 }, (_, i) => {
    const own = keyOf(cells, 3 * i, 0);
    const known = places.get(own) ?? placeNear(places, cells, 3 * i) ?? i;
    places.set(own, known);
    return known;
  });
}

/** Coordinates in cells from the corner of the box, each cell two of what is the same. */
function cellsOf(triangles: Float64Array): Float64Array {
  const { least, sides } = boxOf(triangles);
  const cell = 2 * SAME * Math.max(...sides) || 1;
  return triangles.map((value, i) => (value - least[i % 3]!) / cell);
}

/** What a cell's number along one axis stays below: 2^15, and one beyond at each end. */
const BEYOND = 2 ** 16;

/** The place in one of the seven other cells that a corner is nearest to. */
function placeNear(
  places: Map<number, number>,
  cells: Float64Array,
  at: number,
): number | undefined {
  for (let aside = 1; aside < 8; aside++) {
    const known = places.get(keyOf(cells, at, aside));
    if (known !== undefined) return known;
  }
  return undefined;
}

/** Of the cell of a corner; for each axis whose bit is in `aside`, of the one that is next in this. */
function keyOf(cells: Float64Array, at: number, aside: number): number {
  let key = 0;
  for (let k = 0; k < 3; k++) {
    const cell = Math.floor(cells[at + k]!);
    const next = cells[at + k]! - cell < 0.5 ? -1 : 1;
    key = key * BEYOND + cell + 1 + (aside & (1 << k) ? next : 0);
  }
  return key;
}
