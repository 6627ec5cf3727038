import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * Particles from anywhere on a surface, straight away from it.
 */
export class X3DSurfaceEmitterElement extends forType(
  'SurfaceEmitter',
  undefined,
  particleTypes.SurfaceEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-surface-emitter': X3DSurfaceEmitterElement;
  }
}
