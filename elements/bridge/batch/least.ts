/** As many of a kind are worth being drawn in one call. */
export const LEAST = 8;
