import { coneEmitter as law } from '../../effects/particles/emit/cone-emitter.js';
import type { Emitter } from '../../effects/particles/emit/emitter.js';
import { defineNode } from '../node/define.js';
import { changed, directionField, emitterFields, positionField } from './emitter-fields.js';
import { EmitterNode } from './emitter-node.js';

export class ConeEmitterNode extends EmitterNode {
  protected law(): Emitter {
    return law({
      ...this.speeds,
      position: this.asked('position'),
      direction: this.asked('direction'),
      angle: this.asked('angle'),
    });
  }
}

export const coneEmitter = defineNode<ConeEmitterNode>({
  name: 'ConeEmitter',
  containerField: 'emitter',
  clause: '40.4.2',
  doc: 'Particles from one point, within a cone.',
  rank: 4,
  make: (context) => new ConeEmitterNode(context),
  fields: {
    ...emitterFields,
    ...positionField,
    ...directionField,
    angle: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: Math.PI / 4,
      range: [0, Math.PI],
      dimension: { angle: 1 },
      edit: 'live',
      patch: changed,
      doc: 'Greatest angle between direction and the way of a particle, radians.',
    },
  },
});
