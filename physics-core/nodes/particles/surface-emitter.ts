import type { Emitter } from '../../effects/particles/emit/emitter.js';
import { surfaceEmitter as law } from '../../effects/particles/emit/surface-emitter.js';
import { geometryTypes, type Geometry } from '../../shapes/geometry.js';
import { defineNode } from '../node/define.js';
import { changed, emitterFields } from './emitter-fields.js';
import { EmitterNode } from './emitter-node.js';
import { codeOf, meshOf } from './mesh.js';

export class SurfaceEmitterNode extends EmitterNode {
  protected law(): Emitter {
    return law({ ...this.speeds, mesh: meshOf(this.asked<Geometry | null>('surface')) });
  }
}

export const surfaceEmitter = defineNode<SurfaceEmitterNode>({
  name: 'SurfaceEmitter',
  containerField: 'emitter',
  clause: '40.4.8',
  doc: 'Particles from anywhere on a surface, straight away from it.',
  rank: 4,
  needs: (emitter) => codeOf(emitter.asked('surface')),
  make: (context) => new SurfaceEmitterNode(context),
  fields: {
    ...emitterFields,
    surface: {
      type: 'SFNode',
      access: 'initializeOnly',
      default: null,
      nodes: [...geometryTypes],
      edit: 'live',
      patch: changed,
      doc: 'The geometry on which particles are born; NULL: none are.',
    },
  },
});
