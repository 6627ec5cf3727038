import type { Masses } from './masses.js';
import type { Surface } from './surface.js';

/**
 * What gives way: points of mass, and what acts between them. A step is taken in equal parts: `push`, then all go as fast as
 * they are, then `hold`, and how far each went is how fast it was (small steps; Macklin and others, 2019). What acts by
 * `push` alone is symplectic: nothing is lost, as long as no wave is shorter than a part.
 */
export interface Material {
  readonly masses: Masses;
  readonly surface: Surface;
  /** What surrounds it acts on this surface, which is as finely divided as it bends. */
  readonly hull: Surface;
  /** Where outside is: 1, where the triangles of that look to; -1, behind them; 0: it encloses nothing, and has two sides. */
  readonly side: number;
  /** m³ as laid, of what is solid within; undefined: it is hollow, or encloses nothing. */
  readonly solid?: number;
  /** Metres, of what encloses nothing, where it is not its author's. */
  readonly thickness?: number;
  /** In how many equal parts its forces want a step of `dt` seconds to be taken: no wave is shorter then. */
  parts(dt: number): number;
  /** In so many parts: what would follow more quickly is made softer. Answers by how much: 1, not at all. */
  soften(parts: number, dt: number): number;
  /** Adds to the velocities what forces between its points do in `time` seconds, places being what they are. */
  push(time: number): void;
  /** Takes places, `time` seconds after `before`, to where what does not stretch allows them to be; `again`: once more. */
  hold(time: number, again: boolean): void;
  /** Whether it can keep from going through itself: who may come near whom in a step, and that nobody does. */
  lookAtItself?(thickness: number, dt: number): void;
  keepApart?(friction: number): void;
  /** What else the next step reads, for a snapshot. */
  readonly lasting: readonly (Float64Array | Int32Array | Uint8Array)[];
  /** A snapshot was put back into what it keeps. */
  restored?(): void;
  /** How much longer than they should be `hold` found threads, as a share of their length; 0: none is, or there are none. */
  readonly strain: number;
  /** How much longer than its length what does not stretch is, where there is such. */
  readonly stretched?: number;
}
