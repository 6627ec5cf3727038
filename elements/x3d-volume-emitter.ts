import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * Particles from anywhere within a closed surface.
 */
export class X3DVolumeEmitterElement extends forType(
  'VolumeEmitter',
  undefined,
  particleTypes.VolumeEmitter,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-volume-emitter': X3DVolumeEmitterElement;
  }
}
