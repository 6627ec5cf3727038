import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * A surface that particles bounce off, from both of its sides.
 */
export class X3DBoundedPhysicsModelElement extends forType(
  'BoundedPhysicsModel',
  undefined,
  particleTypes.BoundedPhysicsModel,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-bounded-physics-model': X3DBoundedPhysicsModelElement;
  }
}
