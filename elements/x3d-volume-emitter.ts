import { particleTypes } from '../physics-core/particles.js';
import { forType, X3DNodeElement } from './node-element.js';

/**
 * Particles from anywhere within a closed surface.
 */
export class X3DVolumeEmitterElement extends forType(
  'VolumeEmitter',
  X3DNodeElement,
  particleTypes.VolumeEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-volume-emitter': X3DVolumeEmitterElement;
  }
}
