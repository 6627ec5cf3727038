import { softTypes } from '../physics-core/ropes.js';
import { forType } from './node-element.js';
import { X3DSoftElement } from './soft-element.js';

/**
 * A rope: it only pulls, hangs and swings, lies on bodies and winds round them, and ties what is attached to it.
 *
 * In a Transform its points are where that is, and the LineSet of a Shape in it or beside it is the line along which it is
 * laid. That Shape is drawn where the rope goes: as a tube where it has a Material and the rope a radius, else as a line.
 */
export class X3DRopeElement extends forType('Rope', X3DSoftElement, softTypes.Rope) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-rope': X3DRopeElement;
  }
}
