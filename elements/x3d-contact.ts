import { forType } from './node-element.js';

/**
 * One point at which two collidables touch, for script that hands contacts back to a collection.
 */
export class X3DContactElement extends forType('Contact') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-contact': X3DContactElement;
  }
}
