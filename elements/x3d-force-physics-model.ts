import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * A force that is the same on every particle.
 */
export class X3DForcePhysicsModelElement extends forType(
  'ForcePhysicsModel',
  undefined,
  particleTypes.ForcePhysicsModel,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-force-physics-model': X3DForcePhysicsModelElement;
  }
}
