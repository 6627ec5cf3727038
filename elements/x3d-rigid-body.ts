import { X3DBodyElement } from './body-element.js';
import { forType } from './node-element.js';

/**
 * A body that moves by its mass, velocity and the forces on it; inside a Transform it moves that.
 *
 * `:state(sleeping)` shows while it sleeps, `:state(colliding)` while it touches something and somebody listens to
 * its `collisionstart` or `collisionend`: contacts are not read for a style alone.
 */
export class X3DRigidBodyElement extends forType('RigidBody', X3DBodyElement) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-rigid-body': X3DRigidBodyElement;
  }
}
