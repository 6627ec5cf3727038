import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * Particles from one point, within a cone.
 */
export class X3DConeEmitterElement extends forType(
  'ConeEmitter',
  undefined,
  particleTypes.ConeEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-cone-emitter': X3DConeEmitterElement;
  }
}
