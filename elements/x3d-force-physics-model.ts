import { particleTypes } from '../physics-core/particles.js';
import { forType, X3DNodeElement } from './node-element.js';

/**
 * A force that is the same on every particle.
 */
export class X3DForcePhysicsModelElement extends forType(
  'ForcePhysicsModel',
  X3DNodeElement,
  particleTypes.ForcePhysicsModel,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-force-physics-model': X3DForcePhysicsModelElement;
  }
}
