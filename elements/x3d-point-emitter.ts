import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * Particles from one point, all one way or each another.
 */
export class X3DPointEmitterElement extends forType(
  'PointEmitter',
  undefined,
  particleTypes.PointEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-point-emitter': X3DPointEmitterElement;
  }
}
