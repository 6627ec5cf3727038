import type { Shape, Vec3 } from '../case.js';

/** A rope or a cloth, in words that each library has its own for; SI units. */
export interface SoftScene {
  /** m/s², downwards. */
  gravity: number;
  points: readonly Vec3[];
  /** Of a cloth, whose points lie row by row: how many cells it has along its rows and across. Without it: a rope. */
  cells?: readonly [columns: number, rows: number];
  /** kg of the whole. */
  mass: number;
  /** Of a cloth: newtons for each metre of width that stretch it to twice its length; without it nothing stretches. */
  stretch?: number;
  /** Of a cloth: what it takes to make its squares slanted, N/m. */
  shear?: number;
  /** Half of its thickness, metres; without it it touches nothing. */
  radius?: number;
  friction?: number;
  /** Share of its speed that it loses, 1/s. */
  damping?: number;
  /** Points that stay where they are; `spread`: as many times as far from the y axis as they are laid. */
  fixed: readonly number[];
  spread?: number;
  /** A body that hangs on a point, kg. */
  load?: { point: number; mass: number };
  /** What it falls on, around the origin. */
  ground?: Shape;
}

/** A scene in a library, under way. */
export interface SoftRunning {
  /** Seconds that `step` takes it on. */
  readonly timeStep: number;
  step(): void;
  /** Where its points are now. */
  places(): Vec3[];
  /** From now on nothing is damped, and nothing falls. */
  free(): void;
  destroy(): void;
}

/** A thread between two points: its length and stiffness, N/m, 0 where it does not stretch. */
export interface Thread {
  ends: readonly [number, number];
  length: number;
  stiffness: number;
}

const distance = (a: Vec3, b: Vec3): number => Math.hypot(...a.map((x, k) => x - b[k]!));

/** Along and across the squares of a cloth, and along a rope. Those at an edge stand for half a square. */
export function threadsOf({ points, cells, stretch = 0 }: SoftScene): Thread[] {
  const thread = (a: number, b: number, share: number): Thread => ({
    ends: [a, b],
    length: distance(points[a]!, points[b]!),
    stiffness: share * stretch,
  });
  if (!cells) return points.slice(1).map((_, i) => thread(i, i + 1, 1));
  const [columns, rows] = cells;
  const at = (i: number, j: number): number => j * (columns + 1) + i;
  const share = (i: number, last: number): number => (i % last ? 1 : 0.5);
  const threads: Thread[] = [];
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++) {
      if (i < columns) threads.push(thread(at(i, j), at(i + 1, j), share(j, rows)));
      if (j < rows) threads.push(thread(at(i, j), at(i, j + 1), share(i, columns)));
    }
  return threads;
}

/** Both diagonals of each square: springs that take ½ shear γ² of a square metre that is slanted by γ. */
export function diagonalsOf({ points, cells, shear = 0 }: SoftScene): Thread[] {
  if (!cells || shear === 0) return [];
  const [columns, rows] = cells;
  const diagonals: Thread[] = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const a = j * (columns + 1) + i;
      for (const ends of [
        [a, a + columns + 2],
        [a + 1, a + columns + 1],
      ] as const)
        diagonals.push({
          ends,
          length: distance(points[ends[0]]!, points[ends[1]]!),
          stiffness: shear,
        });
    }
  return diagonals;
}

/** Two triangles of each square of a cloth, three points each; their diagonals lie by turns. */
export function trianglesOf({ cells }: SoftScene): number[] {
  if (!cells) return [];
  const [columns, rows] = cells;
  const index: number[] = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const a = j * (columns + 1) + i;
      const [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
      if ((i + j) % 2 === 0) index.push(a, c, b, a, d, c);
      else index.push(a, d, b, b, d, c);
    }
  return index;
}

/** kg of each point: half of its links, a quarter of its squares, and what hangs on it. */
export function massesOf({ points, cells, mass, load }: SoftScene): number[] {
  const [columns, rows] = cells ?? [points.length - 1, 0];
  const half = (i: number, last: number): number => (last && i % last ? 1 : 0.5);
  const masses = points.map((_, n) => {
    const [i, j] = [n % (columns + 1), Math.floor(n / (columns + 1))];
    return cells
      ? (half(i, columns) * half(j, rows) * mass) / (columns * rows)
      : (half(i, columns) * mass) / columns;
  });
  if (load) masses[load.point]! += load.mass;
  return masses;
}

/** Where a fixed point is held. */
export const heldAt = ({ points, spread = 1 }: SoftScene, point: number): Vec3 => {
  const [x, y, z] = points[point]!;
  return [spread * x, y, spread * z];
};
