import type { Ammo } from './ammo.js';
import { BODY } from './offsets.js';

export { isAwake } from './body-state.js';

// Bodies by their heap pointers, for what happens between Bullet's contact search and its solver. World frame. The views of
// the heap are asked for at every read, since it may have grown.

/** Numbers of a velocity: linear, then angular. */
const VELOCITY = 6;

/** One number of the centre of mass, metres. */
export const originOf = ({ HEAPF32 }: Ammo, body: number, i: number): number =>
  HEAPF32[((body + BODY.origin) >> 2) + i]!;

/** How far apart the centres of mass of two bodies are, metres. */
export const apartBetween = ({ HEAPF32 }: Ammo, a: number, b: number): number =>
  distance(HEAPF32, a + BODY.origin, b + BODY.origin);

/** How fast the centres of mass of two bodies move against each other, m/s. */
export const speedBetween = ({ HEAPF32 }: Ammo, a: number, b: number): number =>
  distance(HEAPF32, a + BODY.linearVelocity, b + BODY.linearVelocity);

/** Of two triples, by their addresses. */
function distance(heap: Float32Array, a: number, b: number): number {
  const p = a >> 2;
  const q = b >> 2;
  const x = heap[p]! - heap[q]!;
  const y = heap[p + 1]! - heap[q + 1]!;
  const z = heap[p + 2]! - heap[q + 2]!;
  return Math.sqrt(x * x + y * y + z * z);
}

/** Component along (x, y, z) of the velocity that a body's material has at an arm from its centre of mass, m/s. */
export function speedAt(
  { HEAPF32 }: Ammo,
  body: number,
  arm: Float64Array,
  x: number,
  y: number,
  z: number,
): number {
  const v = (body + BODY.linearVelocity) >> 2;
  const w = (body + BODY.angularVelocity) >> 2;
  const rx = arm[0]!;
  const ry = arm[1]!;
  const rz = arm[2]!;
  return (
    x * (HEAPF32[v]! + HEAPF32[w + 1]! * rz - HEAPF32[w + 2]! * ry) +
    y * (HEAPF32[v + 1]! + HEAPF32[w + 2]! * rx - HEAPF32[w]! * rz) +
    z * (HEAPF32[v + 2]! + HEAPF32[w]! * ry - HEAPF32[w + 1]! * rx)
  );
}

/** Adds so many times a change to the velocity, six numbers. */
export function addVelocity({ HEAPF32 }: Ammo, body: number, change: Float64Array, s: number) {
  const v = (body + BODY.linearVelocity) >> 2;
  const w = (body + BODY.angularVelocity) >> 2;
  for (let i = 0; i < 3; i++) {
    HEAPF32[v + i]! += s * change[i]!;
    HEAPF32[w + i]! += s * change[3 + i]!;
  }
}

/** M⁻¹, 6 × 6: what an impulse does to the velocity of a body that nothing holds. */
export function writeInverseMass({ HEAPF32 }: Ammo, body: number, out: Float64Array): void {
  const basis = (body + BODY.basis) >> 2;
  const inertia = (body + BODY.inverseInertiaLocal) >> 2;
  const mass = HEAPF32[(body + BODY.inverseMass) >> 2]!;
  out.fill(0);
  for (let i = 0; i < 3; i++) {
    out[i * VELOCITY + i] = mass;
    for (let j = 0; j < 3; j++)
      for (let k = 0; k < 3; k++)
        out[(3 + i) * VELOCITY + 3 + j]! +=
          HEAPF32[basis + 4 * i + k]! * HEAPF32[inertia + k]! * HEAPF32[basis + 4 * j + k]!;
  }
}

/** Where its centre of mass is, and the rows of its rotation. */
export function writeFrame(
  { HEAPF32 }: Ammo,
  body: number,
  origin: Float64Array,
  rows: Float64Array,
): void {
  const basis = (body + BODY.basis) >> 2;
  for (let i = 0; i < 3; i++) {
    origin[i] = HEAPF32[((body + BODY.origin) >> 2) + i]!;
    for (let j = 0; j < 3; j++) rows[3 * i + j] = HEAPF32[basis + 4 * i + j]!;
  }
}
