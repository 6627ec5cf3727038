import { X3DBodyElement } from './body-element.js';
import { forType } from './node-element.js';

/**
 * A body that moves by its mass, velocity and the forces on it; inside a Transform it moves that.
 */
export class X3DRigidBodyElement extends forType('RigidBody', X3DBodyElement) {
  /** The DEF or id of the Transform, Shape or group that it stands for. */
  declare for: string;
}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-rigid-body': X3DRigidBodyElement;
  }
}
