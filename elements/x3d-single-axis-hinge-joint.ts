import { forType } from './node-element.js';

/**
 * Lets two bodies turn about one axis.
 */
export class X3DSingleAxisHingeJointElement extends forType('SingleAxisHingeJoint') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-single-axis-hinge-joint': X3DSingleAxisHingeJointElement;
  }
}
