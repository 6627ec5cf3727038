import type { World } from '../../../../physics-core/inside.js';
import { sphere, type Node } from '../../helpers.js';

export const shapeOf = (w: World, geometry: object = sphere(0.5), fields: object = {}): Node =>
  w.add('CollidableShape', { shape: [geometry], ...fields });
