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

/** Metres: what is thinner, as seen from above, is in the water or not. (Fact: a cloth without thickness sinks.) */
export const THIN = 1e-9;

/**
 * How many times as much a soft solid may displace by its surface as by its cells: beyond that the surface is not closed, or
 * crossed by itself, and cells count. (Fact: a solid whose surface is laid amiss.)
 */
export const LIFTS_ALIKE = 2;

/** Kilograms within this share of each other are the same for people. (Fact: what is known of it says why.) */
export const CALM = 0.01;

// ---- waves -----------------------------------------------------------------------------------------------------------

/** Metres that nobody sees: a surface so flat is still, and what rests in it is not woken for less. (Fact: a surface at rest.) */
export const STILL = 1e-4;

/** Metres: what stirs still water by less does not yet. (Fact: what floats still leaves the surface flat, and that sleeps.) */
export const STIRS = 1e-6;

/** Steps from one look at whether it is still to the next: all heights are gone over. */
export const LOOKS = 16;

/**
 * Of what its footprint lifts, a body's cut is at most such a share: else each would lift the other ever more. (Fact: one as
 * large as its basin stays where it may.)
 */
export const MOST_OF_FOOTPRINT = 0.8;

/** A body's footprint is wider by that than itself. */
export const WIDER = 1.2;

/** Cells on each side of its middle that a footprint has at least: so wherever that is, it slopes evenly. */
export const LEAST_CELLS = 1.5;

/** Share of the longest step with which a field holds: beyond 1 it breaks up (Courant). */
export const COURANT = 0.9;

/** Layers of cells from the top of a solid to its bottom, about: what goes through the surface is in it by and by. (Fact: a soft box floats.) */
export const LAYERS = 8;
