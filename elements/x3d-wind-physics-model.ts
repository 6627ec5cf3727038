import { particleTypes } from '../physics-core/particles.js';
import { forType, X3DNodeElement } from './node-element.js';

/**
 * A wind that pushes particles by their surfaceArea, in gusts.
 */
export class X3DWindPhysicsModelElement extends forType(
  'WindPhysicsModel',
  X3DNodeElement,
  particleTypes.WindPhysicsModel,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-wind-physics-model': X3DWindPhysicsModelElement;
  }
}
