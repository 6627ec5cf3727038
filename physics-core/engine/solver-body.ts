import type { Ammo } from './ammo.js';
import { inverseMassOf } from './body-state.js';
import { BODY, COLLISION_FLAG } from './offsets.js';

// What a solver reads of a body between Bullet's contact search and its own, and what it writes after. By heap pointers,
// world frame; the views of the heap are asked for at every call, since it may have grown.

/** Moment of what can't be turned, kg m². */
const UNTURNABLE = 1e12;

/** Whether its author moves it. */
export const isCarried = ({ HEAP32 }: Ammo, body: number): boolean =>
  (HEAP32[(body + BODY.collisionFlags) >> 2]! & COLLISION_FLAG.kinematic) !== 0;

/** The square of its linear speed. */
export function speedSquared({ HEAPF32 }: Ammo, body: number): number {
  const v = (body + BODY.linearVelocity) >> 2;
  return HEAPF32[v]! ** 2 + HEAPF32[v + 1]! ** 2 + HEAPF32[v + 2]! ** 2;
}

/** The same with its spin, at its radius of gyration: twice its energy by its mass. A ball may spin fast where it is. */
export function swiftnessSquared(ammo: Ammo, body: number): number {
  const { HEAPF32 } = ammo;
  const local = (body + BODY.inverseInertiaLocal) >> 2;
  const inverse = (HEAPF32[local]! + HEAPF32[local + 1]! + HEAPF32[local + 2]!) / 3;
  if (inverse === 0) return speedSquared(ammo, body);
  const w = (body + BODY.angularVelocity) >> 2;
  const spin = HEAPF32[w]! ** 2 + HEAPF32[w + 1]! ** 2 + HEAPF32[w + 2]! ** 2;
  return speedSquared(ammo, body) + (spin * inverseMassOf(ammo, body)) / inverse;
}

/** Inertia and its inverse, 3 × 3, from their `at` on. */
export function readInertia(
  { HEAPF32 }: Ammo,
  body: number,
  inertia: Float64Array,
  inverse: Float64Array,
  at: number,
): void {
  const basis = (body + BODY.basis) >> 2;
  const local = (body + BODY.inverseInertiaLocal) >> 2;
  for (let p = 0; p < 3; p++)
    for (let q = 0; q < 3; q++) {
      let sum = 0;
      let inverseSum = 0;
      for (let k = 0; k < 3; k++) {
        const square = HEAPF32[basis + 4 * p + k]! * HEAPF32[basis + 4 * q + k]!;
        const share = HEAPF32[local + k]!;
        inverseSum += square * share;
        sum += square * (share > 0 ? 1 / share : UNTURNABLE);
      }
      inertia[at + 3 * p + q] = sum;
      inverse[at + 3 * p + q] = inverseSum;
    }
}

/** Speeds and ways that are nothing but rounding, m/s and m, rad/s and rad. */
const ROUNDING = 1e-12;

const rounded = (value: number): number => (Math.abs(value) < ROUNDING ? 0 : value);

/** Linear and angular velocity from `v[at]` on. */
export function writeVelocity({ HEAPF32 }: Ammo, body: number, v: Float64Array, at: number): void {
  for (let k = 0; k < 3; k++) {
    HEAPF32[((body + BODY.linearVelocity) >> 2) + k] = rounded(v[at + k]!);
    HEAPF32[((body + BODY.angularVelocity) >> 2) + k] = rounded(v[at + 3 + k]!);
  }
}

/** Moves it by `d[at]` on, metres, and turns it by a small angle, radians: Bullet makes a rotation of it again in the step. */
export function displace({ HEAPF32: f }: Ammo, body: number, d: Float64Array, at: number): void {
  for (let k = 0; k < 3; k++) f[((body + BODY.origin) >> 2) + k]! += rounded(d[at + k]!);
  const x = rounded(d[at + 3]!);
  const y = rounded(d[at + 4]!);
  const z = rounded(d[at + 5]!);
  const basis = (body + BODY.basis) >> 2;
  for (let k = basis; k < basis + 3; k++) {
    const p = f[k]!;
    const q = f[k + 4]!;
    const r = f[k + 8]!;
    f[k] = p + y * r - z * q;
    f[k + 4] = q + z * p - x * r;
    f[k + 8] = r + x * q - y * p;
  }
}
