import { deformableTypes } from '../physics-core/deformables.js';
import { forType } from './node-element.js';
import { X3DSoftElement } from './soft-element.js';

/**
 * A solid of one soft material within a closed surface, or, with pressure, a skin around what presses against it.
 *
 * In a Transform it is laid where that is, and as what a Shape in it or beside it says: a Sphere, a Box, an
 * IndexedTriangleSet, or any other geometry that is closed. That Shape is drawn where the soft body goes.
 */
export class X3DSoftBodyElement extends forType(
  'SoftBody',
  X3DSoftElement,
  deformableTypes.SoftBody,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-soft-body': X3DSoftBodyElement;
  }
}
