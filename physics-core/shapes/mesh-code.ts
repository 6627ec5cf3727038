// The chunk `meshes`.
import { meshSolidOf } from './mesh-mass.js';
import { meshShapeOf } from './mesh-shape.js';
import type { MeshCode } from './meshes.js';
import { tessellate } from './tessellate.js';

export const provide = (): MeshCode => ({
  tessellate,
  solidOf: meshSolidOf,
  shapeOf: meshShapeOf,
});
