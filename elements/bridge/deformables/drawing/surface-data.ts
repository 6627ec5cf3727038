import type { GeometryData } from '../../geometry/geometry-fields.js';

/** Where a picture lies on a surface. */
export interface Texture {
  /** Texture coordinates, two numbers each. */
  places: ArrayLike<number>;
  /** By which of them its faces lie, and by which points, -1 after each face; without: one for each point. */
  faces?: { points: number[]; places: number[] };
}

/** What a cloth or a soft body is laid as, in its own frame, metres. */
export interface SurfaceData {
  geometry: GeometryData;
  texture?: Texture | undefined;
  /** It has as many cells as the Cloth says. */
  cells?: boolean;
}

/** Texture coordinates, two numbers each, and which each corner of a triangle has. */
export interface TextureOn {
  places: ArrayLike<number>;
  index: ArrayLike<number>;
}

/** From its first point to its last, over so many cells along each side. */
export function spread(columns: number, rows: number): number[] {
  const places: number[] = [];
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++) places.push(i / columns, j / rows);
  return places;
}
