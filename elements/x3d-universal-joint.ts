import { forType } from './node-element.js';

/**
 * Passes rotation on between two shafts that stand at an angle.
 */
export class X3DUniversalJointElement extends forType('UniversalJoint') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-universal-joint': X3DUniversalJointElement;
  }
}
