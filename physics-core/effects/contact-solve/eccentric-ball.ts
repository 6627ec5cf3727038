import type { Body } from '../../dynamics/body.js';
import type { ContactPoint } from '../../engine/contact-point.js';
import { partOf } from '../contacts/contact-part.js';

/**
 * The radius of the ball that a contact point lies on, where that goes round with its body: its middle is not the centre of
 * mass. 0: it is none. `side` 0 is the manifold's first body.
 */
export function eccentricBallAt(point: ContactPoint, body: Body, side: 0 | 1): number {
  const part = partOf(point, body, side);
  if (part?.outline?.kind !== 'ball') return 0;
  const [x, y, z] = part.pose.p;
  const [cx, cy, cz] = body.centerOfMass.p;
  return x === cx && y === cy && z === cz ? 0 : part.outline.radius;
}

/** Whether what touches it there touches a face of it, as far as one knows: it goes on being touched in that plane. */
export function isFlatAt(point: ContactPoint, body: Body, side: 0 | 1): boolean {
  const kind = partOf(point, body, side)?.outline?.kind;
  return kind === 'box' || kind === 'hull' || kind === 'triangles';
}
