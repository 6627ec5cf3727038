import type { Emitter } from '../../effects/particles/emit/emitter.js';
import { polylineEmitter as law } from '../../effects/particles/emit/polyline-emitter.js';
import { defineNode } from '../node/define.js';
import { CoordEmitterNode } from './coord-emitter-node.js';
import { coordFields } from './coord-fields.js';
import { directionField, emitterFields } from './emitter-fields.js';

export class PolylineEmitterNode extends CoordEmitterNode {
  protected law(): Emitter {
    return law({
      ...this.speeds,
      points: this.points,
      index: this.index,
      direction: this.asked('direction'),
    });
  }
}

export const polylineEmitter = defineNode<PolylineEmitterNode>({
  name: 'PolylineEmitter',
  containerField: 'emitter',
  clause: '40.4.7',
  doc: 'Particles from anywhere along lines.',
  rank: 4,
  make: (context) => new PolylineEmitterNode(context),
  fields: {
    ...emitterFields,
    ...directionField,
    ...coordFields({
      doc: 'Which points make a line, counted from 0, with -1 after each line; -1 alone: all in order make one.',
    }),
  },
});
