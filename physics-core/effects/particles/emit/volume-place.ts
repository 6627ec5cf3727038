import { Draws } from './draws.js';
import { Cells } from './cells.js';
import { BIRTH } from './emitter.js';
import type { Place } from './place.js';
import { boxOf } from './triangles.js';

/**
 * Places within a closed mesh, each volume alike. Its box is cut into cells, and those that are wholly outside are left
 * away. A place is drawn in one of the others; where the surface goes through that cell, a ray counts triangles, and what is
 * outside is drawn anew. So the law is exact for bent, hollow and many-part solids, too, and a particle costs a handful of
 * triangles. Undefined where no place is found: in what is flat.
 */
export function placeWithin(triangles: Float64Array, oriented: boolean): Place | undefined {
  const box = boxOf(triangles);
  if (!box.sides.every((side) => side > 0 && Number.isFinite(side))) return undefined;
  const cells = new Cells(triangles, oriented, box);
  if (!cells.place(new Draws(0), new Float64Array(BIRTH))) return undefined;
  return (draws, birth) => cells.place(draws, birth);
}
