// The numbers of this room: unit, reason, and the fact that fixes each.

/** Share of the longest part that forces follow (2 / ω): at all of it the shortest wave only just keeps its height. */
export const SURE = 0.9;

/** Parts of a step, at most, that forces may ask for: what is stiffer is made softer, and told. */
export const MOST_PARTS = 32;

/** Least parts of a step: what does not stretch is gone over once in each. (A hanging sheet of 30 × 30 within 2 mm.) */
export const LEAST_PARTS = 6;

/** Share of its length by which a diagonal is longer than both other edges of its triangles: of a square 1.41. */
export const DIAGONAL = 1.05;

/** kg/m³: of air at 15 °C and 1013.25 hPa (ISO 2533, standard atmosphere). */
export const AIR = 1.225;

/**
 * How a thread that does not stretch gives way all the same, as a share of what its points give way by themselves: between two
 * ends that do not move at all, too far apart, there would be no solution.
 */
export const COMPLIANCE = 1e-6;

/** How fast what does not stretch comes back to its length, m/s, where an edit has left it too long. (Fact: pins that jump.) */
export const FASTEST = 10;
