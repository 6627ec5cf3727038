import type { FrameCost } from './frames.js';

/** What is asked of a library in its page. */
export interface Adapter {
  /** Called until it answers true: the scene is there, and what its physics costs is watched. */
  ready(): boolean;
  /** Milliseconds of physics in the last frame, where no method of the library is watched. */
  physics?(cost: FrameCost): number;
  /** Whether all is here that was asked of another thread. */
  answered?(): boolean;
  /** Of the first thing, metres. */
  height(): number | undefined;
  /** How many things live, where the library knows. */
  count?(): number;
}
