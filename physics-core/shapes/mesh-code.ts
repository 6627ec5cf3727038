// The chunk `meshes`.
import { facesOf } from './faces.js';
import { meshShapeOf } from './mesh-shape.js';
import type { MeshCode } from './meshes.js';

export const provide = (): MeshCode => ({ trianglesOf: facesOf, shapeOf: meshShapeOf });
