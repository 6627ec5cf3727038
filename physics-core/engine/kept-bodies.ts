import type { Ammo } from './ammo.js';
import type { BtBody } from './heap.js';
import { BODY } from './offsets.js';

// Bodies as they stand on the heap, to the last bit.

/** Numbers of a body: the rows of its rotation, its origin, its velocities. */
export const STATE = 18;

/** Numbers of the box that it has in Bullet's tree. */
export const BOX = 6;

/** Where each three of them stand on the heap. */
const PARTS = [
  BODY.basis,
  BODY.basis + 16,
  BODY.basis + 32,
  BODY.origin,
  BODY.linearVelocity,
  BODY.angularVelocity,
] as const;

/** Numbers of its place. */
const PLACE_PARTS = 4;

export function saveState({ HEAPF32 }: Ammo, body: number, to: Float32Array, at: number): void {
  for (const part of PARTS) for (let k = 0; k < 3; k++) to[at++] = HEAPF32[(part + body) / 4 + k]!;
}

/** Puts it there, with all that Bullet makes of that. */
export function loadState(
  { HEAPF32 }: Ammo,
  body: BtBody,
  pointer: number,
  from: Float32Array,
  at: number,
): void {
  PARTS.forEach((part, n) => {
    for (let k = 0; k < 3; k++) HEAPF32[(part + pointer) / 4 + k] = from[at + 3 * n + k]!;
    if (n === PLACE_PARTS - 1) body.setCenterOfMassTransform(body.getWorldTransform());
  });
}
