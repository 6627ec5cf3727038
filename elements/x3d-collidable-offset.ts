import { forType } from './node-element.js';

/**
 * Places one collidable away from the origin of its body.
 */
export class X3DCollidableOffsetElement extends forType('CollidableOffset') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collidable-offset': X3DCollidableOffsetElement;
  }
}
