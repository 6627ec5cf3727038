import { forType } from './node-element.js';

/**
 * A world of bodies and joints, with its gravity and solver settings.
 */
export class X3DRigidBodyCollectionElement extends forType('RigidBodyCollection') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-rigid-body-collection': X3DRigidBodyCollectionElement;
  }
}
