import { meshes } from '../../shapes/meshes.js';
import { Effect, type EffectDescriptor } from '../effect/effect.js';

/** Triangle meshes and hulls: no work in the step beyond Bullet's own, but the author may want to know who uses them. */
export class MeshShapes extends Effect {}

export const meshShapes: EffectDescriptor<MeshShapes> = {
  name: 'mesh shapes',
  causes: 'a body whose geometry is made of triangles or of a hull',
  chunk: meshes,
  load: () => new MeshShapes(),
};
