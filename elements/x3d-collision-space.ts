import { forType } from './node-element.js';

/**
 * Groups collidables of a CollisionCollection, and switches them together.
 */
export class X3DCollisionSpaceElement extends forType('CollisionSpace') {
  /** `'*'` for all of its world; otherwise those among its children, which reading gives. */
  declare collidables: string | Element[] | null;
}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collision-space': X3DCollisionSpaceElement;
  }
}
