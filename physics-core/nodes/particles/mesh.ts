import type { Chunk } from '../../base/chunk.js';
import { add, quaternionOf, rotate } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { Geometry, Mesh } from '../../shapes/geometry.js';
import { meshes, type MeshCode } from '../../shapes/meshes.js';

/** What `meshOf` needs for what there is. */
export const codeOf = (data: unknown): Chunk<MeshCode>[] => (data ? [meshes] : []);

/** A geometry as triangles, where it sits; NULL has none. */
export function meshOf(geometry: Geometry | null): Mesh {
  if (!geometry) return { points: [], index: [] };
  const { points, index } = meshes.code.tessellate(geometry);
  const { translation, rotation } = geometry;
  if (!translation && !rotation) return { points, index };
  const turn = quaternionOf(rotation ?? [0, 0, 1, 0]);
  const placed: number[] = [];
  for (let i = 0; i < points.length; i += 3)
    placed.push(...add(translation ?? [0, 0, 0], rotate(turn, points.slice(i, i + 3) as Vec3)));
  return { points: placed, index };
}
