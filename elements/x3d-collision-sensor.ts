import { forType } from './node-element.js';

/**
 * Reports the contacts of a CollisionCollection.
 */
export class X3DCollisionSensorElement extends forType('CollisionSensor') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-collision-sensor': X3DCollisionSensorElement;
  }
}
