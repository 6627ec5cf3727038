import { forType } from './node-element.js';

/**
 * A world of bodies and joints, with its gravity and solver settings.
 */
export class X3DRigidBodyCollectionElement extends forType('RigidBodyCollection') {
  /** Whether it gives the default world of its `<x3d>` its fields. */
  declare default: boolean;
  /** Collections of one `<x3d>` with the same name here share a world. */
  declare sharedWorld: string;
}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-rigid-body-collection': X3DRigidBodyCollectionElement;
  }
}
