import type { Geometry, Mesh } from './geometry.js';
import type { Shaped, Workshop } from './build.js';
import type { Form } from './forms/form.js';
import type { Faces } from './forms/polytope.js';
import type { TriangleForm } from './forms/triangle.js';
import type { Hull } from './hull.js';
import type { Solid, Tensor } from './mass.js';
import type { Surface } from './surface/surface.js';
import { Chunk } from '../base/chunk.js';
import type { Vec3 } from '../fields/types.js';
import { boundsOf, type Bounds } from './bounds.js';
import { axisScale } from './scale.js';

/** What only geometry made of triangles, or of a hull, needs. */
export interface MeshCode {
  /** Any geometry as triangles. */
  tessellate(geometry: Geometry): Mesh;
  /** What one encloses by its triangles. */
  solidOf(geometry: Geometry): Solid;
  /** The Bullet shape of anything by its triangles. */
  shapeOf(geometry: Geometry, exact: boolean, workshop: Workshop): Shaped | undefined;
  /** What bounds a hull; `hull` undefined: its points are flat. */
  facesOf(points: readonly number[], hull: Hull | undefined): Faces;
  /** The form of what a linear map makes of a ball. */
  ellipsoid(squares: Tensor): Form;
  /** Triangles as something that touches. */
  surfaceOf(mesh: Mesh): Surface;
  /** The form of one of its triangles, which is told. */
  triangle(): TriangleForm;
}

export const meshes = new Chunk<MeshCode>({
  name: 'meshes',
  causes:
    'geometry that collides and is no whole Box, Sphere, Cylinder or Cone, or is scaled unevenly',
});

/** What these need. */
export const codeFor = (geometries: readonly (Geometry | null)[]): Chunk<MeshCode> | undefined =>
  geometries.every((each) => !each || (isPrimitive(each) && !isTurned(each))) ? undefined : meshes;

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

/** Whether what scales it along its axes has rounding beside that: then its box is that of its triangles. */
const isTurned = ({ linear }: Geometry): boolean =>
  linear?.some((value, i) => i % 4 !== 0 && value !== 0) ?? false;

/** The box around a geometry that stands in its collidable as it is. */
export function boxAround(g: Geometry): Bounds {
  const half = isTurned(g) ? undefined : halfExtents(g);
  if (!half || !isPrimitive(g)) return boundsOf(meshes.code.tessellate(g).points);
  const max = half.map((value, i) => value * Math.abs(g.linear?.[4 * i] ?? 1)) as Vec3;
  return { min: max.map((value) => -value) as Vec3, max };
}

function halfExtents(g: Geometry): Vec3 | undefined {
  switch (g.type) {
    case 'Box': {
      const [x, y, z] = g.size ?? [2, 2, 2];
      return [x / 2, y / 2, z / 2];
    }
    case 'Sphere': {
      const r = g.radius ?? 1;
      return [r, r, r];
    }
    case 'Cylinder':
    case 'Cone': {
      const r = (g.type === 'Cone' ? g.bottomRadius : g.radius) ?? 1;
      return [r, (g.height ?? 2) / 2, r];
    }
    default:
      return undefined;
  }
}
