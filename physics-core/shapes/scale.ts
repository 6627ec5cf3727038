import type { Vec3 } from '../fields/types.js';

const TOLERANCE = 1e-6;

/** The factors along x, y, z where `linear` only scales along the axes; undefined where it shears or turns. */
export function axisScale(linear: number[] | undefined): Vec3 | undefined {
  if (!linear) return [1, 1, 1];
  const size = Math.max(...linear.map(Math.abs));
  const straight = [1, 2, 3, 5, 6, 7].every((i) => Math.abs(linear[i]!) <= TOLERANCE * size);
  if (!straight) return undefined;
  const factors = [0, 4, 8].map((i) => Math.abs(linear[i]!)) as Vec3;
  // Scales that agree to rounding count as equal, so that a sphere stays a sphere.
  const same = (a: number, b: number): boolean => Math.abs(a - b) <= TOLERANCE * size;
  if (same(factors[1], factors[0])) factors[1] = factors[0];
  if (same(factors[2], factors[0])) factors[2] = factors[0];
  return factors;
}
