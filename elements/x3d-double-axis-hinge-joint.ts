import { forType } from './node-element.js';

/**
 * A wheel's joint: turns about its own axis, steers and springs along another.
 */
export class X3DDoubleAxisHingeJointElement extends forType('DoubleAxisHingeJoint') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-double-axis-hinge-joint': X3DDoubleAxisHingeJointElement;
  }
}
