import type { Ammo } from './ammo.js';
import { BODY } from './offsets.js';

/**
 * Puts the centre of mass of a body there, `rotation` by rows. On the heap alone, for who looks: Bullet itself can't step on
 * from there.
 */
export function placeBody(
  { HEAPF32 }: Ammo,
  body: number,
  place: ArrayLike<number>,
  rotation: Float64Array,
): void {
  const basis = (body + BODY.basis) >> 2;
  const origin = (body + BODY.origin) >> 2;
  for (let i = 0; i < 3; i++) {
    HEAPF32[origin + i] = place[i]!;
    for (let k = 0; k < 3; k++) HEAPF32[basis + 4 * i + k] = rotation[3 * i + k]!;
  }
}
