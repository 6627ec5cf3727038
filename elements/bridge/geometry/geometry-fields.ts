import type { codecs } from '../../../physics-core/inside.js';

/** Geometry as the core takes it; see physics-core/shapes/geometry.ts. */
export interface GeometryData {
  type: string;
  [field: string]: unknown;
}

export interface GeometryField {
  type: keyof typeof codecs;
  /** Its values are lengths. */
  length?: true;
}

const size: GeometryField = { type: 'SFVec3f', length: true };
const length: GeometryField = { type: 'SFFloat', length: true };
const flag: GeometryField = { type: 'SFBool' };
const indices: GeometryField = { type: 'MFInt32' };
const count: GeometryField = { type: 'SFInt32' };

/** The X3D geometry that the core knows by name; anything else is taken as x3dom's triangles. */
export const geometryFields: Record<string, Record<string, GeometryField>> = {
  Box: { size },
  Sphere: { radius: length },
  Cylinder: { radius: length, height: length, side: flag, top: flag, bottom: flag },
  Cone: { bottomRadius: length, height: length, side: flag, bottom: flag },
  IndexedFaceSet: { coordIndex: indices, ccw: flag },
  IndexedTriangleSet: { index: indices, ccw: flag },
  TriangleSet: { ccw: flag },
  ElevationGrid: {
    xDimension: count,
    zDimension: count,
    xSpacing: length,
    zSpacing: length,
    height: { type: 'MFFloat', length: true },
  },
};

const byLowerName = new Map(Object.keys(geometryFields).map((name) => [name.toLowerCase(), name]));

/** The X3D name of a geometry tag that the core knows. */
export const knownGeometry = (lowerName: string): string | undefined => byLowerName.get(lowerName);

/** Geometry with a `coord` child. */
export const hasCoord = (type: string): boolean => /Set$/.test(type);
