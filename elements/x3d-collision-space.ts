import { forType } from './node-element.js';

/**
 * Groups collidables of a CollisionCollection, and switches them together.
 */
export class X3DCollisionSpaceElement extends forType('CollisionSpace') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collision-space': X3DCollisionSpaceElement;
  }
}
