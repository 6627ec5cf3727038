import { Effect } from '../effect.js';

/** Triangle meshes and hulls: no work in the step beyond Bullet's own, but the author may want to know who uses them. */
export class MeshShapes extends Effect {
  readonly name = 'mesh shapes';
}
