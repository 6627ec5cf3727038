import type { Rotation, Vec3 } from '../fields/types.js';

/** Where a geometry sits in its collidable, and the scale or shear put on it before that. */
export interface Placement {
  translation?: Vec3;
  rotation?: Rotation;
  /** Row-major 3 × 3: the scale of the Transforms above the Shape. */
  linear?: number[];
}

interface Faces {
  coord?: number[] | { point: number[] };
  ccw?: boolean;
}

/** X3D geometry as plain data: X3D's field names, lengths in metres; absent fields have X3D's defaults. */
export type Geometry = Placement &
  (
    | { type: 'Box'; size?: Vec3 }
    | { type: 'Sphere'; radius?: number }
    | {
        type: 'Cylinder';
        radius?: number;
        height?: number;
        side?: boolean;
        top?: boolean;
        bottom?: boolean;
      }
    | {
        type: 'Cone';
        bottomRadius?: number;
        /** X3DOM's: above 0 the cone is cut off. */
        topRadius?: number;
        height?: number;
        side?: boolean;
        bottom?: boolean;
        top?: boolean;
      }
    | { type: 'Rectangle2D'; size?: [number, number] }
    | { type: 'Disk2D'; innerRadius?: number; outerRadius?: number }
    | { type: 'Torus'; innerRadius?: number; outerRadius?: number }
    | ({ type: 'TriangleStripSet'; stripCount?: number[] } & Faces)
    | ({ type: 'TriangleFanSet'; fanCount?: number[] } & Faces)
    | ({ type: 'QuadSet' } & Faces)
    | ({ type: 'IndexedTriangleStripSet'; index?: number[] } & Faces)
    | ({ type: 'IndexedTriangleFanSet'; index?: number[] } & Faces)
    | ({ type: 'IndexedQuadSet'; index?: number[] } & Faces)
    | ({ type: 'IndexedFaceSet'; coordIndex?: number[] } & Faces)
    | ({ type: 'IndexedTriangleSet'; index?: number[] } & Faces)
    | ({ type: 'TriangleSet' } & Faces)
    | {
        type: 'ElevationGrid';
        xDimension?: number;
        zDimension?: number;
        xSpacing?: number;
        zSpacing?: number;
        height?: number[];
      }
    | { type: 'Mesh'; points: number[]; index: number[] }
  );

/** Points (flat xyz) and triangles (three indices each). */
export interface Mesh {
  points: number[];
  index: number[];
}

export const geometryTypes = [
  'Box',
  'Sphere',
  'Cylinder',
  'Cone',
  'IndexedFaceSet',
  'IndexedTriangleSet',
  'TriangleSet',
  'TriangleStripSet',
  'TriangleFanSet',
  'QuadSet',
  'IndexedTriangleStripSet',
  'IndexedTriangleFanSet',
  'IndexedQuadSet',
  'Rectangle2D',
  'Disk2D',
  'Torus',
  'ElevationGrid',
  'Mesh',
] as const;
