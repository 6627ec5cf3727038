/** Triangles that share their corners: points, x y z, and of each triangle the numbers of its corners. */
export interface Facets {
  readonly points: ArrayLike<number>;
  readonly index: ArrayLike<number>;
}

/** The corners of each triangle, one after the other, x y z. */
export function cornersOf({ points, index }: Facets): number[] {
  const corners: number[] = [];
  for (let i = 0; i < index.length; i++)
    for (let k = 0; k < 3; k++) corners.push(points[3 * index[i]! + k]!);
  return corners;
}
