/**
 * Particles that live at once in a world, in however many systems, and so in one: they fly in four milliseconds of a step, and
 * each is met eight times in one at most, so that what a step does is bounded.
 */
export const MOST_PARTICLES = 100_000;
