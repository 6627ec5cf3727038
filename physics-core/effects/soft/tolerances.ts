// The numbers of this room: unit, reason, and the fact that fixes each.

/**
 * What is put elsewhere faster than this, m/s, is not carried there: it jumps, and what hangs on it comes along without any
 * speed of that. (Fact: an attachment that jumps by 100 m flings nothing.)
 */
export const CARRIED = 20;

/**
 * A hit gives a body more than so many times what its weight does in a step; what rubs or bears it gives no more than that, and
 * ropes answer it in the next step: at once they would pull what friction holds. (Facts: a box on a floor is held by friction;
 * what is struck from above goes no lower.)
 */
export const HIT = 4;

/** How much farther than it goes in a step a point looks for something to touch, as a share of the radius of the rope. */
export const AHEAD = 0.5;

/**
 * Share of its length by which a link has to rise above what it lies on to be farther from it there: it lies along a face if it
 * does not, and on both ends of that. Less than what rounding leaves would let it rock. (Fact: a link over a narrow box.)
 */
export const LEVEL = 1e-3;

/** Halvings in which the nearest place on a link is found: 24 µm of one of 10 cm. (Fact: what lies on an edge does not creep.) */
export const HALVINGS = 12;

/**
 * What is nearest to a link along it rather than across it is met by its points: less than this share of its direction is
 * across. (Fact: a rope of long links across two bars.)
 */
export const STEEP = 0.3;

/**
 * Both points of a link touch what is flat between them, if the link would be no deeper in it there than this share of its
 * radius. (Fact: over a drum it slips as it should; what lies on a floor costs no more than its points.)
 */
export const SAGS = 0.25;

/** Share of the stiffest bending that a step follows: at all of it the shortest waves only just keep their height. */
export const SURE = 0.9;

/** Share of a velocity that single precision, and rounding on the way there, may change. */
export const SAME = 1e-5;

/** m/s or rad/s by which joints may find bodies to go otherwise than ropes found them: what single precision keeps of a few m/s. */
export const AGREES = 1e-6;
