import { geometryFields, type FieldType, type GeometryType } from '../../../physics-core/inside.js';

/** Geometry as the core takes it; see physics-core/shapes/geometry.ts. */
export interface GeometryData {
  type: string;
  [field: string]: unknown;
}

/** What is read by its fields; of anything else the triangles that are drawn are taken. */
const NAMES: GeometryType[] = [
  'Box',
  'Sphere',
  'Cylinder',
  'Cone',
  'IndexedFaceSet',
  'IndexedTriangleSet',
  'TriangleSet',
  'ElevationGrid',
];

const byLowerName = new Map(NAMES.map((name) => [name.toLowerCase(), name]));

/** The X3D name of a geometry tag that is read by its fields. */
export const knownGeometry = (lowerName: string): GeometryType | undefined =>
  byLowerName.get(lowerName);

/** Geometry with a `coord` child. */
export const hasCoord = (type: string): boolean => /Set$/.test(type);

/** Its attributes, by the type of their values. */
export const attributesOf = (type: GeometryType): [name: string, type: FieldType][] =>
  Object.entries(geometryFields(type)).filter(([name]) => name !== 'coord');

/** All numbers with fractions are lengths there. */
export const isLength = (type: FieldType): boolean => /Float|Vec/.test(type);
