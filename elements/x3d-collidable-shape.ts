import { forType } from './node-element.js';

/**
 * The shape that collides, drawn where it stands in the scene.
 */
export class X3DCollidableShapeElement extends forType('CollidableShape') {
  /** The DEF or id of the Transform, Shape or group that it stands for. */
  declare for: string;
}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collidable-shape': X3DCollidableShapeElement;
  }
}
