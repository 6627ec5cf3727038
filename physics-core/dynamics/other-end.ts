import type { Body } from './body.js';
import type { Joint } from './joint.js';

/** What a joint holds a body to; undefined: the world. */
export const otherEnd = ({ body1, body2 }: Joint, body: Body): Body | undefined =>
  body1 === body ? body2 : body1;
