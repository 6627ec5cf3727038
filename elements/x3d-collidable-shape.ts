import { forType } from './node-element.js';

/**
 * The shape that collides, drawn where it stands in the scene.
 */
export class X3DCollidableShapeElement extends forType('CollidableShape') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collidable-shape': X3DCollidableShapeElement;
  }
}
