import { waterTypes } from '../physics-core/water.js';
import { forType } from './node-element.js';

/**
 * A box of water, or of another liquid: bodies, ropes, cloths and soft bodies float in it, and it brakes them.
 *
 * In a Transform it is where that is, and as large as the Box of a Shape beside it, which is what is seen of it.
 */
export class X3DWaterVolumeElement extends forType(
  'WaterVolume',
  undefined,
  waterTypes.WaterVolume,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-water-volume': X3DWaterVolumeElement;
  }
}
