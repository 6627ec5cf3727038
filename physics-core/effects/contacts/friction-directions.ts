import { hypot } from '../../base/exact/index.js';
import type { ContactPoint } from '../../engine/contact-point.js';
import type { Vec3 } from '../../fields/types.js';

/** Above this share of x in a normal, x gives no direction in the surface. */
const ALONG_X = 0.9;

/**
 * Friction direction 1: the one that is given, or the world's x axis, or z where the surface faces along x; laid into the
 * surface with the normal (nx, ny, nz). Direction 2 is at right angles to it: z on a floor.
 */
export function layInSurface(
  out: Float64Array,
  nx: number,
  ny: number,
  nz: number,
  given: Vec3 | undefined,
): void {
  const facesX = Math.abs(nx) > ALONG_X;
  const x = given ? given[0] : facesX ? 0 : 1;
  const y = given ? given[1] : 0;
  const z = given ? given[2] : facesX ? 1 : 0;
  const along = x * nx + y * ny + z * nz;
  out[0] = x - along * nx;
  out[1] = y - along * ny;
  out[2] = z - along * nz;
  const size = hypot(out[0], out[1], out[2]) || 1;
  for (let i = 0; i < 3; i++) out[i]! /= size;
}

/** Friction direction 1 where nobody gives one. */
export function firstDirection(point: ContactPoint): Vec3 {
  layInSurface(first, point.normal(0), point.normal(1), point.normal(2), undefined);
  return [first[0]!, first[1]!, first[2]!];
}

const first = new Float64Array(3);
