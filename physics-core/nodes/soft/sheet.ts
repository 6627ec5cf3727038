import type { Mesh } from '../../shapes/geometry.js';

/** A flat sheet of cells around the origin in the x-y plane, metres: points row by row from its lower left corner. */
export function sheet(width: number, height: number, cells: readonly [number, number]): Mesh {
  const [columns, rows] = cells.map((n) => Math.max(1, Math.round(n))) as [number, number];
  const points: number[] = [];
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++)
      points.push((i / columns - 0.5) * width, (j / rows - 0.5) * height, 0);
  const index: number[] = [];
  const at = (i: number, j: number): number => j * (columns + 1) + i;
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      // The diagonals go both ways in turns: none of the two is the stiffer one.
      if ((i + j) % 2 === 0) index.push(a, b, c, a, c, d);
      else index.push(a, b, d, b, c, d);
    }
  return { points, index };
}
