import { deformableTypes } from '../physics-core/deformables.js';
import { forType } from './node-element.js';
import { X3DSoftElement } from './soft-element.js';

/**
 * A sheet of threads: it hangs, folds, blows in the wind, and lies on bodies, which it holds and pushes.
 *
 * In a Transform it is laid where that is, and as what a Shape in it or beside it says: an IndexedTriangleSet, an
 * IndexedFaceSet, an X3DOM Plane, or any other geometry. That Shape is drawn where the cloth goes, and is seen from both
 * sides. With a `size` it is a sheet, and the Shape needs an Appearance alone.
 */
export class X3DClothElement extends forType('Cloth', X3DSoftElement, deformableTypes.Cloth) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-cloth': X3DClothElement;
  }
}
