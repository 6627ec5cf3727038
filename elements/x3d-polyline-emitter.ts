import { particleTypes } from '../physics-core/particles.js';
import { forType, X3DNodeElement } from './node-element.js';

/**
 * Particles from anywhere along lines.
 */
export class X3DPolylineEmitterElement extends forType(
  'PolylineEmitter',
  X3DNodeElement,
  particleTypes.PolylineEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-polyline-emitter': X3DPolylineEmitterElement;
  }
}
