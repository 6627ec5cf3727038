import { softTypes } from '../physics-core/ropes.js';
import { forType } from './node-element.js';

/**
 * Ties a point of a rope, a cloth or a soft body to a body, or to a place in the world: each pulls the other.
 *
 * What it ties is what it stands in, or what it names as `softBody`; `body` may be the name of a body, as at a joint.
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
