import type { Joint } from '../../dynamics/joint.js';

/** A joint as the bodies know it that it holds. */
export interface BodyJoint extends Joint {
  /** The body is there, or in the world again. */
  bodyReady(): void;
  /** The body goes, or out of the world. */
  bodyGone(): void;
  massChanged(): void;
}
