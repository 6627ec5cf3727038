import type { Emitter } from '../../effects/particles/emit/emitter.js';
import { pointEmitter as law } from '../../effects/particles/emit/point-emitter.js';
import { defineNode } from '../node/define.js';
import { directionField, emitterFields, positionField } from './emitter-fields.js';
import { EmitterNode } from './emitter-node.js';

export class PointEmitterNode extends EmitterNode {
  protected law(): Emitter {
    return law({
      ...this.speeds,
      position: this.asked('position'),
      direction: this.asked('direction'),
    });
  }
}

export const pointEmitter = defineNode<PointEmitterNode>({
  name: 'PointEmitter',
  containerField: 'emitter',
  clause: '40.4.6',
  doc: 'Particles from one point, all one way or each another.',
  rank: 4,
  make: (context) => new PointEmitterNode(context),
  fields: { ...emitterFields, ...positionField, ...directionField },
});
