import type { Ammo } from './ammo.js';
import type { BtBody } from './heap.js';
import { BODY } from './offsets.js';
import type { Scratch } from './scratch.js';

/** Gives bodies their velocities. Two ways: straight into the heap (about 10 times faster), or through the API. */
export interface VelocityWriter {
  /** Linear then angular, six numbers from `v[at]` on, world frame. */
  write(body: BtBody, pointer: number, v: Float64Array, at: number): void;
}

export class HeapVelocityWriter implements VelocityWriter {
  readonly #ammo: Ammo;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  write(_: BtBody, pointer: number, v: Float64Array, at: number): void {
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

/** For another Ammo build. */
export class ApiVelocityWriter implements VelocityWriter {
  readonly #scratch: Scratch;

  constructor(scratch: Scratch) {
    this.#scratch = scratch;
  }

  write(body: BtBody, _: number, v: Float64Array, at: number): void {
    body.setLinearVelocity(this.#scratch.vector(v[at]!, v[at + 1]!, v[at + 2]!));
    body.setAngularVelocity(this.#scratch.vector(v[at + 3]!, v[at + 4]!, v[at + 5]!));
  }
}
