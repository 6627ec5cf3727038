import { log } from '../../base/exact/index.js';
import { dot3, multiply4, writeTurn } from '../../base/flat-math.js';
import { writeAxes } from '../../base/matrix.js';

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

/**
 * Radians about `other` that are taken at once, and parts of a step at most. Bodies of mass come to this at spins of 30 rad/s
 * and more at `game`; moments that no body has (one larger than both others together), as authors may write them, at a few.
 */
const AT_ONCE = 0.5;
const MOST_PARTS = 64;

const axes = new Float64Array(9);
const spin = new Float64Array(3);
const turn = new Float64Array(4);

/** Turns an orientation as the top goes on for so many seconds with its angular momentum, if nothing else acts. */
export function turnFreely(
  orientation: Float64Array,
  top: Top,
  momentum: Float64Array,
  time: number,
): void {
  const uneven = Math.abs(top.uneven * time) * Math.sqrt(dot3(momentum, 0, momentum, 0));
  const parts = Math.min(MOST_PARTS, Math.ceil(uneven / AT_ONCE)) || 1;
  for (let i = 0; i < parts; i++) turnPart(orientation, top, momentum, time / parts);
}

function turnPart(
  orientation: Float64Array,
  { axis, other, own, uneven, across }: Top,
  momentum: Float64Array,
  time: number,
): void {
  turnAbout(orientation, other, uneven, momentum, time / 2);
  turnAbout(orientation, axis, own, momentum, time);
  for (let i = 0; i < 3; i++) spin[i] = momentum[i]! / across;
  writeTurn(turn, spin, time);
  multiply4(orientation, turn, 0, orientation, 0);
  turnAbout(orientation, other, uneven, momentum, time / 2);
}

/** About one of its own axes, at a rate that goes with its share of the momentum. */
function turnAbout(
  orientation: Float64Array,
  axis: number,
  rate: number,
  momentum: Float64Array,
  time: number,
): void {
  if (rate === 0) return;
  writeAxes(axes, orientation, 0);
  spin.fill(0);
  spin[axis] = rate * dot3(axes, axis * 3, momentum, 0);
  writeTurn(turn, spin, time);
  multiply4(orientation, orientation, 0, turn, 0);
}
