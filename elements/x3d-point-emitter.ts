import { particleTypes } from '../physics-core/particles.js';
import { forType, X3DNodeElement } from './node-element.js';

/**
 * Particles from one point, all one way or each another.
 */
export class X3DPointEmitterElement extends forType(
  'PointEmitter',
  X3DNodeElement,
  particleTypes.PointEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-point-emitter': X3DPointEmitterElement;
  }
}
