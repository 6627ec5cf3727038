import { levels } from '../../../../physics-core/dynamics/levels.js';
import type { World } from '../../../../physics-core/inside.js';
import type { Node, Vec3 } from '../../helpers.js';

/** m/s² of the worlds of these facts. */
export const G = 9.8;

export const LEVELS = levels.map(({ name }) => name);

type Pair = readonly [number, number];
const pair = (of: number | Pair): Pair => (typeof of === 'number' ? [of, of] : of);

/** A level sheet around the y axis: cells along x and z, metres of each side, how high; points row by row along x. */
export function flat(
  cells: number | Pair,
  size: number | Pair,
  y: number,
): { type: string; coord: number[]; index: number[] } {
  const [columns, rows] = pair(cells);
  const [width, depth] = pair(size);
  const coord: number[] = [];
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++)
      coord.push((i / columns - 0.5) * width, y, (j / rows - 0.5) * depth);
  const index: number[] = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const a = j * (columns + 1) + i;
      const [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
      if ((i + j) % 2 === 0) index.push(a, c, b, a, d, c);
      else index.push(a, d, b, b, d, c);
    }
  return { type: 'IndexedTriangleSet', coord, index };
}

/** The four corners of such a sheet, by their numbers. */
export const cornersOf = (cells: number): number[] => [
  0,
  cells,
  cells * (cells + 1),
  (cells + 1) ** 2 - 1,
];

/** It touches nothing unless it is given a thickness. */
export const addCloth = (to: World, fields: Record<string, unknown> = {}): Node =>
  to.add('Cloth', { thickness: 0, ...fields });

/** Ties a point to what the fields say: the world, or a body. */
export const tie = (
  to: World,
  softBody: Node,
  index: number,
  fields: Record<string, unknown> = {},
): Node => to.add('SoftBodyAttachment', { softBody, index, ...fields });

export const places = (cloth: Node): Vec3[] => cloth.get('positions') as Vec3[];

export const place = (cloth: Node, i: number): Vec3 => places(cloth).at(i)!;
