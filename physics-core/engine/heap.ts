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

/** Linear then angular velocity of the body at a pointer, six numbers from `out[at]` on, world frame. */
export function readVelocity({ HEAPF32 }: Ammo, body: number, out: Float64Array, at: number): void {
  readTwo(HEAPF32, body + BODY.linearVelocity, body + BODY.angularVelocity, out, at);
}

/** Force then torque that the step applies to it beside gravity, N and N m. */
export function readLoad({ HEAPF32 }: Ammo, body: number, out: Float64Array, at: number): void {
  readTwo(HEAPF32, body + BODY.totalForce, body + BODY.totalTorque, out, at);
}

function readTwo(f: Float32Array, first: number, second: number, out: Float64Array, at: number) {
  for (let k = 0; k < 3; k++) {
    out[at + k] = f[(first >> 2) + k]!;
    out[at + 3 + k] = f[(second >> 2) + k]!;
  }
}

/** Bullet's number of what it is near to, of the step under way or the last one; below 0: it has none. */
export const islandAt = ({ HEAP32 }: Ammo, body: number): number =>
  HEAP32[(body + BODY.islandTag) >> 2]!;

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

  velocity(pointer: number, out: Float64Array, at: number): void {
    readVelocity(this.#ammo, pointer, out, at);
  }

  load(pointer: number, out: Float64Array, at: number): void {
    readLoad(this.#ammo, pointer, out, at);
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

  island(pointer: number): number {
    return islandAt(this.#ammo, pointer);
  }
}
