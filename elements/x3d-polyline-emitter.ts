import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * Particles from anywhere along lines.
 */
export class X3DPolylineEmitterElement extends forType(
  'PolylineEmitter',
  undefined,
  particleTypes.PolylineEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-polyline-emitter': X3DPolylineEmitterElement;
  }
}
