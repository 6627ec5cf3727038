import type { FieldType, Rotation, Vec3 } from '../fields/types.js';

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
    | { type: 'Mesh'; points?: number[]; index?: number[] }
  );

/** X3D's Coordinate as plain data: points alone, flat xyz, metres. */
export interface Coordinate {
  type: 'Coordinate';
  point?: number[];
}

/** X3D's lines as plain data: points, flat xyz, metres; how many each line has, or which, with -1 after each line. */
export type Line =
  | { type: 'LineSet'; coord?: number[]; vertexCount?: number[] }
  | { type: 'IndexedLineSet'; coord?: number[]; coordIndex?: number[] };

/** Points (flat xyz) and triangles (three indices each). */
export interface Mesh {
  points: number[];
  index: number[];
}

const FACES = { coord: 'MFVec3f', ccw: 'SFBool' } as const;
const INDEXED = { ...FACES, index: 'MFInt32' } as const;
const RADII = { innerRadius: 'SFFloat', outerRadius: 'SFFloat' } as const;
const CAPS = { side: 'SFBool', top: 'SFBool', bottom: 'SFBool' } as const;

/** The types of what each says of itself. */
const OWN_FIELDS = {
  Box: { size: 'SFVec3f' },
  Sphere: { radius: 'SFFloat' },
  Cylinder: { radius: 'SFFloat', height: 'SFFloat', ...CAPS },
  Cone: { bottomRadius: 'SFFloat', topRadius: 'SFFloat', height: 'SFFloat', ...CAPS },
  IndexedFaceSet: { ...FACES, coordIndex: 'MFInt32' },
  IndexedTriangleSet: INDEXED,
  TriangleSet: FACES,
  TriangleStripSet: { ...FACES, stripCount: 'MFInt32' },
  TriangleFanSet: { ...FACES, fanCount: 'MFInt32' },
  QuadSet: FACES,
  IndexedTriangleStripSet: INDEXED,
  IndexedTriangleFanSet: INDEXED,
  IndexedQuadSet: INDEXED,
  Rectangle2D: { size: 'SFVec2f' },
  Disk2D: RADII,
  Torus: RADII,
  ElevationGrid: {
    xDimension: 'SFInt32',
    zDimension: 'SFInt32',
    xSpacing: 'SFFloat',
    zSpacing: 'SFFloat',
    height: 'MFFloat',
  },
  Mesh: { points: 'MFVec3f', index: 'MFInt32' },
} as const satisfies Record<Geometry['type'], Record<string, FieldType>>;

const PLACEMENT = { translation: 'SFVec3f', rotation: 'SFRotation', linear: 'SFMatrix3f' } as const;

export type GeometryType = keyof typeof OWN_FIELDS;

export const geometryTypes = Object.keys(OWN_FIELDS) as GeometryType[];

export const isGeometry = (type: string): type is GeometryType => Object.hasOwn(OWN_FIELDS, type);

/** Every field of a geometry, and its X3D type. */
export const geometryFields = (type: GeometryType): Record<string, FieldType> => ({
  ...OWN_FIELDS[type],
  ...PLACEMENT,
});
