import type { Emitter } from '../../effects/particles/emit/emitter.js';
import { volumeEmitter as law } from '../../effects/particles/emit/volume-emitter.js';
import { defineNode } from '../node/define.js';
import { CoordEmitterNode } from './coord-emitter-node.js';
import { coordFields } from './coord-fields.js';
import { changed, directionField, emitterFields } from './emitter-fields.js';
import { codeOf, meshOf } from './mesh.js';

export class VolumeEmitterNode extends CoordEmitterNode {
  protected law(): Emitter {
    const { points: coord, index: coordIndex } = this;
    return law({
      ...this.speeds,
      mesh: meshOf(coord.length > 0 ? { type: 'IndexedFaceSet', coord, coordIndex } : null),
      internal: this.asked('internal'),
      direction: this.asked('direction'),
    });
  }
}

export const volumeEmitter = defineNode<VolumeEmitterNode>({
  name: 'VolumeEmitter',
  containerField: 'emitter',
  clause: '40.4.9',
  doc: 'Particles from anywhere in a volume that its faces enclose.',
  rank: 4,
  needs: (emitter) => codeOf(emitter.asked('coord')),
  make: (context) => new VolumeEmitterNode(context),
  fields: {
    ...emitterFields,
    ...directionField,
    ...coordFields({
      doc: 'Which points make a face, counted from 0, with -1 after each face: together they are closed.',
    }),
    internal: {
      type: 'SFBool',
      access: 'initializeOnly',
      default: true,
      edit: 'live',
      patch: changed,
      doc: 'TRUE: particles are born anywhere inside; FALSE: only on the surface.',
    },
  },
});
