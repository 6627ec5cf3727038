import type { Dimension, FieldType } from './types.js';

/**
 * Greatest magnitudes, in SI units. Bullet works in single precision, which ends at 3.4e38: of numbers up to these it can
 * form squares, cubes and products with a mass; of geometry the fourth powers that its search for contacts needs.
 */
export const BOUNDS = {
  /** Metres, and so m/s and m/s²; newtons, kilograms; whatever has no unit. */
  plain: 1e12,
  /** Radians, rad/s: a turn and a half million of them. */
  angle: 1e6,
  /** kg m², N m. */
  moment: 1e24,
  /** Metres of a geometry, scaled as it is. */
  geometry: 1e9,
} as const;

/** Least mass of what moves, kilograms: its inverse, squared, is still a number. */
export const LEAST_MASS = 1e-12;

interface Bounded {
  type: FieldType;
  dimension?: Dimension;
  /** Where it is not that of its dimension. */
  most?: number;
}

/** The greatest magnitude of the numbers of a field. Times are X3D's own double precision, and no business of Bullet's. */
export function boundOf({ type, dimension, most }: Bounded): number {
  if (most !== undefined) return most;
  if (type === 'SFTime') return Infinity;
  if (!dimension || type === 'SFRotation') return BOUNDS.plain;
  if (dimension.angle) return BOUNDS.angle;
  return dimension.length && (dimension.mass || dimension.force) ? BOUNDS.moment : BOUNDS.plain;
}

/** A bound as messages say it. */
export const shownBound = (bound: number): string =>
  bound < 1e6 ? String(bound) : bound.toExponential().replace('+', '');
