// Principal moments of inertia.

/** Moments that agree to this count as equal. */
const SAME = 1e-6;

/** Moments that differ by less than this share of the largest turn a body like a ball. */
const ALIKE = 1e-3;

/** Whether one rate of angular damping serves all axes. */
export const areEqualMoments = ([x, y, z]: readonly [number, number, number]): boolean =>
  Math.abs(x - y) <= SAME * x && Math.abs(x - z) <= SAME * x;

/** Whether a body turns about every axis as about any other. */
export function turnsAlike(moments: readonly number[]): boolean {
  const most = Math.max(...moments);
  return most - Math.min(...moments) < ALIKE * most;
}
