// The numbers of this room: unit, reason, and the fact that fixes each.

/** What is pushed by more than this share of its weight does not sleep on. (Fact: a cloth that falls on what sleeps wakes it.) */
export const WAKES = 0.01;

/**
 * What is put elsewhere faster than this, m/s, jumps: it takes what hangs on it along without any speed of that, and what does
 * not stretch comes back no faster. (Fact: pins that jump by 100 m fling nothing.)
 */
export const CARRIED = 20;

/**
 * How fast what begins a step inside a body comes out of it, m/s: threads hand that on to what is beside it, as speed. (Fact: a
 * cloth on a box comes to rest.)
 */
export const RETURN = 0.05;

/** How much farther than it goes in a step a point looks for something to touch, as a share of how far it keeps away. */
export const AHEAD = 1;

/**
 * The same for what has no thickness, metres: a point that swings turns round within a step, and would be inside before it is
 * looked for. (Fact: a block of jelly that lies on a floor trembles less and less.)
 */
export const TURNS = 0.003;

/** Stretched by more than this share what does not stretch is told: as long as it bears less it holds. */
export const STRAINED = 0.05;

/** Share of what pushes a body by itself that rounding leaves of it: more than that something else did. */
export const UNFELT = 0.01;

/**
 * Threads, ties and touches are gone over again in a part of a step where what does not stretch is longer than this share, so
 * many times at most. (Fact: a ball of 100 kg on a cloth of 1 kg.)
 */
export const TAUT = 0.03;
export const ROUNDS = 16;

/** Times that touches of a lattice are gone over in a part of a step. (Fact: a block of jelly on a floor comes to rest.) */
export const SWEEPS = 4;

/** Rounds in which threads go to their lengths after a jump, at most: each is exact along its line. (Fact: pins that jump.) */
export const SETTLING = 200;

/** Normals at the corners of a triangle that agree to this cosine have no edge of a body between them. (Facts: a ball, a box.) */
export const FLAT = 0.9;

/** Pieces of an edge, at most, at whose ends a surface is looked at between its points. */
export const FINEST = 4;

/** Seconds: what is stretched for less than that whips. */
export const WHIPS = 0.5;
