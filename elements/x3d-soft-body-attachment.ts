import { softTypes } from '../physics-core/ropes.js';
import { forType } from './node-element.js';

/**
 * Ties a point of a rope to a body, or to a place in the world: each pulls the other.
 *
 * The rope is what it stands in, or what it names; `body` may be the name of a body, as at a joint.
 */
export class X3DSoftBodyAttachmentElement extends forType(
  'SoftBodyAttachment',
  undefined,
  softTypes.SoftBodyAttachment,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-soft-body-attachment': X3DSoftBodyAttachmentElement;
  }
}
