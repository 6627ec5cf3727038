import { LEAST_COVER, LEAST_SPREAD, MOST_ASIDE, MOST_CELLS } from '../tolerances.js';
import { coverOf, raysOf, type Cover, type Grid } from './lattice-cover.js';
import { Surface } from './surface.js';
import { finiteTriangles } from './weld.js';

/** Points sampled along each side of a cell. */
const SAMPLES = 4;

/** Rays that triangles may have to be looked at for: about a second. Fewer are sampled where there would be more. */
const MOST_RAYS = 3e7;

/** How far beyond its cell a point of the surface may lie and be carried by it, in cells. */
const BEYOND = 1;

/** The box cells that a solid covers. */
export interface Cells {
  /** Of one cell, metres. */
  readonly size: readonly number[];
  readonly count: number;
  /** Eight of each, x going fastest, then y. */
  readonly corners: Int32Array;
  /** What of each is covered. */
  readonly cover: Cover;
  /** Of the corners: x, y, z of each. */
  readonly places: Float64Array;
  readonly surface: Surface;
  /** Another surface that they carry, by its points as laid and its triangles. */
  carry(points: ArrayLike<number>, triangles: ArrayLike<number>): Surface;
}

const NOTHING = new Surface([], 8, [], []);

const NONE: Cells = {
  size: [1, 1, 1],
  count: 0,
  corners: new Int32Array(0),
  cover: {
    shares: new Float64Array(0),
    middles: new Float64Array(0),
    spreads: new Float64Array(0),
  },
  places: new Float64Array(0),
  surface: NOTHING,
  carry: () => NOTHING,
};

/** Fills a closed surface with cells, `resolution` of them along the longest side of its box. */
export function cellsOf(
  points: ArrayLike<number>,
  index: ArrayLike<number>,
  resolution: number,
): Cells {
  const triangles = finiteTriangles(points, index);
  const grid = gridOf(points, triangles, resolution);
  if (!grid) return NONE;
  const rays = raysOf(points, triangles, grid);
  let samples = SAMPLES;
  while (samples > 1 && rays * samples * samples > MOST_RAYS) samples--;
  const cover = coverOf(points, triangles, grid, samples);
  const kept = Array.from(cover.shares.keys()).filter((cell) => cover.shares[cell]! > 0);
  if (kept.length === 0) return NONE;
  const { corners, places } = cornersOf(grid, kept);
  const carry: Cells['carry'] = (own, faces) => surfaceOf(own, faces, grid, kept, corners);
  return {
    size: grid.size,
    count: kept.length,
    corners,
    cover: coverOfKept(cover, kept),
    places,
    surface: carry(points, triangles),
    carry,
  };
}

/** None of them so little that nothing is left of it. */
function coverOfKept({ shares, middles, spreads }: Cover, kept: readonly number[]): Cover {
  const three = kept.flatMap((cell) => [3 * cell, 3 * cell + 1, 3 * cell + 2]);
  const inside = (middle: number): number => Math.min(MOST_ASIDE, Math.max(-MOST_ASIDE, middle));
  return {
    shares: Float64Array.from(kept, (cell) => Math.max(LEAST_COVER, shares[cell]!)),
    middles: Float64Array.from(three, (j) => inside(middles[j]!)),
    spreads: Float64Array.from(three, (j) => Math.max(LEAST_SPREAD, spreads[j]!)),
  };
}

/** The box around the triangles, in cells that are about as long as wide and high; null where it is flat. */
function gridOf(points: ArrayLike<number>, triangles: Int32Array, resolution: number): Grid | null {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const i of triangles)
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k]!, points[3 * i + k]!);
      high[k] = Math.max(high[k]!, points[3 * i + k]!);
    }
  const sides = high.map((h, k) => h - low[k]!);
  const longest = Math.max(...sides);
  // A side that is a millionth of another is none; nor is one whose square single precision has no number for.
  if (!(Math.min(...sides) > 1e-6 * longest) || !(longest > 1e-12) || !(longest < 1e12))
    return null;
  let along = Math.max(
    1,
    Math.min(MOST_CELLS, Math.floor(Number.isFinite(resolution) ? resolution : 1)),
  );
  const counted = (): number[] =>
    sides.map((side) => Math.max(1, Math.round((side / longest) * along)));
  while (along > 1 && counted().reduce((product, n) => product * n) > MOST_CELLS)
    along = Math.max(1, Math.floor(0.9 * along));
  const counts = counted();
  return { low, counts, size: sides.map((side, k) => side / counts[k]!) };
}

/** x, y, z of a cell among all of the grid. */
const cellAt = (cell: number, { counts }: Grid, k: number): number => {
  if (k === 0) return cell % counts[0]!;
  const row = Math.floor(cell / counts[0]!);
  return k === 1 ? row % counts[1]! : Math.floor(row / counts[1]!);
};

function cornersOf(
  grid: Grid,
  kept: readonly number[],
): { corners: Int32Array; places: Float64Array } {
  const { low, size, counts } = grid;
  const wide = counts[0]! + 1;
  const layer = wide * (counts[1]! + 1);
  const numbers = new Int32Array(layer * (counts[2]! + 1)).fill(-1);
  const corners = new Int32Array(8 * kept.length);
  const places: number[] = [];
  kept.forEach((cell, n) => {
    for (let c = 0; c < 8; c++) {
      const x = cellAt(cell, grid, 0) + (c & 1);
      const y = cellAt(cell, grid, 1) + ((c >> 1) & 1);
      const z = cellAt(cell, grid, 2) + (c >> 2);
      const at = z * layer + y * wide + x;
      if (numbers[at]! < 0) {
        numbers[at] = places.length / 3;
        places.push(low[0]! + x * size[0]!, low[1]! + y * size[1]!, low[2]! + z * size[2]!);
      }
      corners[8 * n + c] = numbers[at]!;
    }
  });
  return { corners, places: Float64Array.from(places) };
}

/** Each point as the mean of the corners of its cell, or of the nearest one that is kept. */
function surfaceOf(
  points: ArrayLike<number>,
  triangles: ArrayLike<number>,
  grid: Grid,
  kept: readonly number[],
  corners: Int32Array,
): Surface {
  const { low, size, counts } = grid;
  const count = Math.floor(points.length / 3);
  const carriers = new Int32Array(8 * count);
  const shares = new Float64Array(8 * count);
  const nearest = nearestKept(grid, kept);
  const within = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    let cell = 0;
    for (let k = 2; k >= 0; k--) {
      const at = (points[3 * i + k]! - low[k]!) / size[k]!;
      cell = cell * counts[k]! + Math.min(counts[k]! - 1, Math.max(0, Math.floor(at) || 0));
    }
    const n = nearest(cell);
    for (let k = 0; k < 3; k++) {
      const at = (points[3 * i + k]! - low[k]!) / size[k]! - cellAt(kept[n]!, grid, k);
      within[k] = Number.isFinite(at) ? Math.min(1 + BEYOND, Math.max(-BEYOND, at)) : 0.5;
    }
    for (let c = 0; c < 8; c++) {
      carriers[8 * i + c] = corners[8 * n + c]!;
      let share = 1;
      for (let k = 0; k < 3; k++) share *= (c >> k) & 1 ? within[k]! : 1 - within[k]!;
      shares[8 * i + c] = share;
    }
  }
  return new Surface(triangles, 8, carriers, shares);
}

/** The number of the kept cell that is nearest to one of the grid: found once for each that is asked for. */
function nearestKept(grid: Grid, kept: readonly number[]): (cell: number) => number {
  const { counts, size } = grid;
  const found = new Int32Array(counts[0]! * counts[1]! * counts[2]!).fill(-1);
  kept.forEach((cell, n) => (found[cell] = n));
  const apart = (a: number, b: number): number => {
    let square = 0;
    for (let k = 0; k < 3; k++) {
      const way = (cellAt(a, grid, k) - cellAt(b, grid, k)) * size[k]!;
      square += way * way;
    }
    return square;
  };
  return (cell) => {
    if (found[cell]! >= 0) return found[cell]!;
    let best = 0;
    for (let n = 1; n < kept.length; n++)
      if (apart(cell, kept[n]!) < apart(cell, kept[best]!)) best = n;
    found[cell] = best;
    return best;
  };
}
