import { writeQuaternion } from '../base/math.js';
import type { Ammo } from './ammo.js';
import { ACTIVATION, BODY } from './offsets.js';

export type BtBody = Ammo['btRigidBody']['prototype'];

/** Reads what changes every step, and puts places right. Two ways: straight from the heap (about 20 times faster), or through the API. */
export interface BodyReader {
  /** Pose of the centre of mass: x y z qx qy qz qw, from `out[at]` on. */
  pose(body: BtBody, pointer: number, out: Float64Array, at: number): void;
  /** Linear then angular velocity, six numbers, world frame. */
  velocity(body: BtBody, pointer: number, out: Float64Array, at: number): void;
  /** Force then torque that the next step applies beside gravity, six numbers; zeros where they can't be known. */
  load(body: BtBody, pointer: number, out: Float64Array, at: number): void;
  /** Moves a body by so many metres. */
  shift(body: BtBody, pointer: number, x: number, y: number, z: number): void;
  /** Whether Bullet leaves it where it is. */
  sleeps(body: BtBody, pointer: number): boolean;
  /** Bullet's island number of the last step, or -1 where it can't be known. */
  island(body: BtBody, pointer: number): number;
}

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

/** After a heap growth `HEAPF32` is another array, so it is asked for at every read. */
export class HeapReader implements BodyReader {
  readonly #ammo: Ammo;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  pose(_: BtBody, pointer: number, out: Float64Array, at: number): void {
    const heap = this.#ammo.HEAPF32;
    const o = (pointer + BODY.origin) >> 2;
    out[at] = heap[o]!;
    out[at + 1] = heap[o + 1]!;
    out[at + 2] = heap[o + 2]!;
    writeOrientation(heap, pointer, out, at + 3);
  }

  velocity(_: BtBody, pointer: number, out: Float64Array, at: number): void {
    const heap = this.#ammo.HEAPF32;
    const v = (pointer + BODY.linearVelocity) >> 2;
    const w = (pointer + BODY.angularVelocity) >> 2;
    for (let i = 0; i < 3; i++) {
      out[at + i] = heap[v + i]!;
      out[at + 3 + i] = heap[w + i]!;
    }
  }

  load(_: BtBody, pointer: number, out: Float64Array, at: number): void {
    const heap = this.#ammo.HEAPF32;
    const f = (pointer + BODY.totalForce) >> 2;
    const t = (pointer + BODY.totalTorque) >> 2;
    for (let i = 0; i < 3; i++) {
      out[at + i] = heap[f + i]!;
      out[at + 3 + i] = heap[t + i]!;
    }
  }

  shift(_: BtBody, pointer: number, x: number, y: number, z: number): void {
    const heap = this.#ammo.HEAPF32;
    const o = (pointer + BODY.origin) >> 2;
    heap[o]! += x;
    heap[o + 1]! += y;
    heap[o + 2]! += z;
  }

  sleeps(_: BtBody, pointer: number): boolean {
    return this.#ammo.HEAP32[(pointer + BODY.activationState) >> 2] === ACTIVATION.sleeping;
  }

  island(_: BtBody, pointer: number): number {
    return this.#ammo.HEAP32[(pointer + BODY.islandTag) >> 2]!;
  }
}

/** For another Ammo build, whose offsets `heap-check.ts` could not confirm. */
export class ApiReader implements BodyReader {
  pose(body: BtBody, _: number, out: Float64Array, at: number): void {
    const transform = body.getWorldTransform();
    const origin = transform.getOrigin();
    out[at] = origin.x();
    out[at + 1] = origin.y();
    out[at + 2] = origin.z();
    const rotation = transform.getRotation();
    out[at + 3] = rotation.x();
    out[at + 4] = rotation.y();
    out[at + 5] = rotation.z();
    out[at + 6] = rotation.w();
  }

  velocity(body: BtBody, _: number, out: Float64Array, at: number): void {
    const linear = body.getLinearVelocity();
    out[at] = linear.x();
    out[at + 1] = linear.y();
    out[at + 2] = linear.z();
    const angular = body.getAngularVelocity();
    out[at + 3] = angular.x();
    out[at + 4] = angular.y();
    out[at + 5] = angular.z();
  }

  load(_body: BtBody, _pointer: number, out: Float64Array, at: number): void {
    out.fill(0, at, at + 6);
  }

  shift(body: BtBody, _: number, x: number, y: number, z: number): void {
    // The body's own vector, not a copy.
    const origin = body.getWorldTransform().getOrigin();
    origin.setValue(origin.x() + x, origin.y() + y, origin.z() + z);
  }

  sleeps(body: BtBody): boolean {
    return !body.isActive();
  }

  island(): number {
    return -1;
  }
}
