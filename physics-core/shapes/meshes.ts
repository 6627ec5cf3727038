import type { Geometry, Mesh } from './geometry.js';
import type { Shaped, Workshop } from './build.js';
import { Chunk } from '../base/chunk.js';
import { axisScale } from './scale.js';

/** What only geometry made of triangles, or of a hull, needs. */
export interface MeshCode {
  /** The points and triangles of a geometry that is made of them, before its `linear`. */
  trianglesOf(geometry: Geometry): Mesh;
  /** The Bullet shape of anything by its triangles. */
  shapeOf(geometry: Geometry, exact: boolean, workshop: Workshop): Shaped | undefined;
}

export const meshes = new Chunk<MeshCode>(
  'meshes',
  'geometry that collides and is no whole Box, Sphere, Cylinder or Cone, or is scaled unevenly',
);

/** What these need. */
export const codeFor = (geometries: readonly (Geometry | null)[]): Chunk<MeshCode> | undefined =>
  geometries.every((each) => !each || isPrimitive(each)) ? undefined : meshes;

/** Whether Bullet has a shape for it as it is. */
export function isPrimitive(g: Geometry): boolean {
  const scale = axisScale(g.linear);
  if (!scale) return false;
  const [x, y, z] = scale;
  switch (g.type) {
    case 'Box':
      return true;
    case 'Sphere':
      return x === y && y === z;
    case 'Cylinder':
      return x === z && g.side !== false && g.top !== false && g.bottom !== false;
    case 'Cone':
      return x === z && !g.topRadius && g.side !== false && g.bottom !== false;
    default:
      return false;
  }
}
