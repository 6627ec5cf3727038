import { forType } from './node-element.js';

/**
 * Lets two bodies move against each other along one axis only.
 */
export class X3DSliderJointElement extends forType('SliderJoint') {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-slider-joint': X3DSliderJointElement;
  }
}
