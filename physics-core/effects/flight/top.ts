import { log } from '../../base/exact/index.js';

/** How a body with these moments turns freely: nearly as a top that is round about `axis`. */
export interface Top {
  axis: number;
  /** Turns about the angular momentum at L / across, and about its own axis at this times its share of L. */
  across: number;
  own: number;
  /** What is not round about it: a turn about `other` at this times its share of L. */
  other: number;
  uneven: number;
  /** Its largest moment by its smallest. */
  thinness: number;
}

/** Round about the axis that leaves the two most like moments across. */
export function topOf(moments: readonly number[]): Top {
  const apart = (i: number): number => Math.abs(log(moments[(i + 1) % 3]! / moments[(i + 2) % 3]!));
  const axis = [0, 1, 2].reduce((best, i) => (apart(i) < apart(best) ? i : best), 0);
  const other = (axis + 2) % 3;
  const across = moments[(axis + 1) % 3]!;
  return {
    axis,
    across,
    own: 1 / moments[axis]! - 1 / across,
    other,
    uneven: 1 / moments[other]! - 1 / across,
    thinness: Math.max(...moments) / Math.min(...moments),
  };
}
