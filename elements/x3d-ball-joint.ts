import { forType } from './node-element.js';

/**
 * Holds two bodies together at a point.
 */
export class X3DBallJointElement extends forType('BallJoint') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-ball-joint': X3DBallJointElement;
  }
}
