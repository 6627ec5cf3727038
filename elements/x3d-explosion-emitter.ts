import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * All particles at once, from one point every way.
 */
export class X3DExplosionEmitterElement extends forType(
  'ExplosionEmitter',
  undefined,
  particleTypes.ExplosionEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-explosion-emitter': X3DExplosionEmitterElement;
  }
}
