// The chunk `meshes`.
import { ellipsoidForm } from './ellipsoid.js';
import { flatFaces } from './forms/flat-faces.js';
import { hullFaces } from './forms/hull-faces.js';
import { TriangleForm } from './forms/triangle.js';
import { meshSolidOf } from './mesh-mass.js';
import { meshShapeOf } from './mesh-shape.js';
import type { MeshCode } from './meshes.js';
import { Surface } from './surface/surface.js';
import { tessellate } from './tessellate.js';

export const provide = (): MeshCode => ({
  tessellate,
  solidOf: meshSolidOf,
  shapeOf: meshShapeOf,
  facesOf: (points, hull) => (hull ? hullFaces(points, hull.triangles) : flatFaces(points)),
  ellipsoid: ellipsoidForm,
  surfaceOf: ({ points, index }) => new Surface(points, index),
  triangle: () => new TriangleForm(),
});
