import { writeQuaternion } from '../base/math.js';
import type { Ammo } from './ammo.js';
import { ACTIVATION, BODY } from './offsets.js';

export type BtBody = Ammo['btRigidBody']['prototype'];

/** The quaternion of the btRigidBody at a pointer, from Bullet's matrix. */
export function writeOrientation(
  heap: Float32Array,
  pointer: number,
  out: Float64Array,
  at: number,
): void {
  const b = (pointer + BODY.basis) >> 2;
  writeQuaternion(
    out,
    at,
    heap[b]!,
    heap[b + 1]!,
    heap[b + 2]!,
    heap[b + 4]!,
    heap[b + 5]!,
    heap[b + 6]!,
    heap[b + 8]!,
    heap[b + 9]!,
    heap[b + 10]!,
  );
}

/**
 * Reads bodies by their pointers, and puts places right: straight on the heap, about twenty times faster than by Ammo's
 * methods. After a heap growth `HEAPF32` is another array, so it is asked for at every read.
 */
export class BodyReader {
  readonly #ammo: Ammo;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** Pose of the centre of mass: x y z qx qy qz qw, from `out[at]` on. */
  pose(pointer: number, out: Float64Array, at: number): void {
    const heap = this.#ammo.HEAPF32;
    const o = (pointer + BODY.origin) >> 2;
    out[at] = heap[o]!;
    out[at + 1] = heap[o + 1]!;
    out[at + 2] = heap[o + 2]!;
    writeOrientation(heap, pointer, out, at + 3);
  }

  /** Linear then angular velocity, six numbers, world frame. */
  velocity(pointer: number, out: Float64Array, at: number): void {
    this.#readPair(BODY.linearVelocity, BODY.angularVelocity, pointer, out, at);
  }

  /** Force then torque that the next step applies beside gravity, six numbers. */
  load(pointer: number, out: Float64Array, at: number): void {
    this.#readPair(BODY.totalForce, BODY.totalTorque, pointer, out, at);
  }

  #readPair(first: number, second: number, pointer: number, out: Float64Array, at: number): void {
    const heap = this.#ammo.HEAPF32;
    const a = (pointer + first) >> 2;
    const b = (pointer + second) >> 2;
    for (let i = 0; i < 3; i++) {
      out[at + i] = heap[a + i]!;
      out[at + 3 + i] = heap[b + i]!;
    }
  }

  /** Moves a body by so many metres. */
  shift(pointer: number, x: number, y: number, z: number): void {
    const heap = this.#ammo.HEAPF32;
    const o = (pointer + BODY.origin) >> 2;
    heap[o]! += x;
    heap[o + 1]! += y;
    heap[o + 2]! += z;
  }

  /** Whether Bullet leaves it where it is. */
  sleeps(pointer: number): boolean {
    return this.#ammo.HEAP32[(pointer + BODY.activationState) >> 2] === ACTIVATION.sleeping;
  }

  /** Bullet's island number of the last step. */
  island(pointer: number): number {
    return this.#ammo.HEAP32[(pointer + BODY.islandTag) >> 2]!;
  }
}
