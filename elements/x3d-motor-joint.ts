import { forType } from './node-element.js';

/**
 * Turns two bodies against each other; holds nothing together.
 */
export class X3DMotorJointElement extends forType('MotorJoint') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-motor-joint': X3DMotorJointElement;
  }
}
