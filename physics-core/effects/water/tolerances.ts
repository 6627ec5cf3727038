// The numbers of this room: unit, reason, and the fact that fixes each.

/**
 * How many times its own weight water lifts a body at most: nothing that is solid is lighter, and no step could show how
 * what is yet lighter moves. (Fact: what is a thousand times lighter neither explodes nor leaps.)
 */
export const MOST_LIFT = 1000;

/**
 * How many times over drag would stop a body in a step, from where on it is that of the speed at the end of the step: below
 * that it is much the same as at its start. (Fact: what is a thousand times lighter.)
 */
export const HASTY = 0.5;

/** Kilograms within this share of each other are the same for people. (Fact: what is known of it says why.) */
export const CALM = 0.01;
