import type { Emitter } from '../../effects/particles/emit/emitter.js';
import { explosionEmitter as law } from '../../effects/particles/emit/explosion-emitter.js';
import { defineNode } from '../node/define.js';
import { emitterFields, positionField } from './emitter-fields.js';
import { EmitterNode } from './emitter-node.js';

export class ExplosionEmitterNode extends EmitterNode {
  override get atOnce(): boolean {
    return true;
  }

  protected law(): Emitter {
    return law({ ...this.speeds, position: this.asked('position') });
  }
}

export const explosionEmitter = defineNode<ExplosionEmitterNode>({
  name: 'ExplosionEmitter',
  containerField: 'emitter',
  clause: '40.4.3',
  doc: 'All particles at once from one point, each another way.',
  rank: 4,
  make: (context) => new ExplosionEmitterNode(context),
  fields: { ...emitterFields, ...positionField },
});
