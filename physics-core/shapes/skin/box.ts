import type { Facets } from './facets.js';

/** Corners of a cube, and of the triangles of its sides, outward. */
const SIGNS = Array.from({ length: 8 }, (_, i) =>
  [i & 1, i & 2, i & 4].map((bit) => (bit ? 1 : -1)),
);
const SIDES = [
  [0, 4, 6, 2],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 2, 3, 1],
  [4, 5, 7, 6],
].flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]);

export const boxFacets = (half: readonly number[]): Facets => ({
  points: SIGNS.flatMap((signs) => signs.map((sign, k) => sign * half[k]!)),
  index: SIDES,
});
