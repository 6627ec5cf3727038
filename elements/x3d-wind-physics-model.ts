import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * A wind that pushes particles by their surfaceArea, and bodies by what it sees of them where its system pushes, in gusts.
 */
export class X3DWindPhysicsModelElement extends forType(
  'WindPhysicsModel',
  undefined,
  particleTypes.WindPhysicsModel,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-wind-physics-model': X3DWindPhysicsModelElement;
  }
}
