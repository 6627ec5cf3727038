import type { Ammo } from './ammo.js';
import { BODY } from './offsets.js';

/** Gives bodies their velocities: straight on the heap, about ten times faster than by Ammo's methods. */
export class VelocityWriter {
  readonly #ammo: Ammo;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** Linear then angular, six numbers from `v[at]` on, world frame. */
  write(pointer: number, v: Float64Array, at: number): void {
    const heap = this.#ammo.HEAPF32;
    const linear = (pointer + BODY.linearVelocity) >> 2;
    const angular = (pointer + BODY.angularVelocity) >> 2;
    heap[linear] = v[at]!;
    heap[linear + 1] = v[at + 1]!;
    heap[linear + 2] = v[at + 2]!;
    heap[angular] = v[at + 3]!;
    heap[angular + 1] = v[at + 4]!;
    heap[angular + 2] = v[at + 5]!;
  }
}
