import { forType } from './node-element.js';

/**
 * Who collides with whom, and how their surfaces are.
 */
export class X3DCollisionCollectionElement extends forType('CollisionCollection') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collision-collection': X3DCollisionCollectionElement;
  }
}
