import type { Ammo } from './ammo.js';
import { VELOCITY, type MovingBodies } from './moving-bodies.js';
import { BODY } from './offsets.js';

/** Words of a btRigidBody: its place and its velocity. */
const O = BODY.origin >> 2;
const V = BODY.linearVelocity >> 2;

/** Share of a velocity and of its change that single precision may take or add in a step. */
export const SAME = 1e-6;

/** m/s: rounding of what is nearly nothing. */
const TINY = 1e-12;

/** What rests trembles; stacks take longer to calm down where that is led on evenly, m/s (measured). */
export const RESTING = 0.01;

/** How much more than by itself a body may speed up where it is pushed evenly, as a square: rounding. */
export const EVEN = 1.02;

/** Whether a velocity is what it was and what it gained. */
export const same = (now: number, before: number, gained: number): boolean =>
  Math.abs(now - before - gained) <= SAME * (Math.abs(before) + Math.abs(gained)) + TINY;

/** What is known of the motion of a slot's body: nothing, an even acceleration, or more than that. */
export const MOTION = { unknown: 0, falls: 1, other: 2 } as const;

/**
 * Most bodies only fall: Bullet has taken them ½ a dt² too far in its step, and they are put back in one pass over the
 * heap. Who rests, or was hit, stays as it is; who slides or rolls is led on as evenly. All others are left aside.
 */
export class FreeFall {
  /** `MOTION`, and m/s², by slot. */
  motions = new Uint8Array(16);
  accelerations = new Float64Array(16 * 3);
  /** Slots that were left aside; the first `asideCount` count. */
  aside = new Int32Array(16);
  asideCount = 0;

  set(slot: number, motion: number, acceleration?: Float64Array): void {
    if (slot >= this.motions.length) this.#grow(slot);
    this.motions[slot] = motion;
    for (let i = 0; i < 3 && acceleration; i++) this.accelerations[slot * 3 + i] = acceleration[i]!;
  }

  #grow(slot: number): void {
    const room = 2 * (slot + 1);
    const motions = new Uint8Array(room);
    motions.set(this.motions);
    this.motions = motions;
    const accelerations = new Float64Array(3 * room);
    accelerations.set(this.accelerations);
    this.accelerations = accelerations;
    this.aside = new Int32Array(room);
  }

  /**
   * After a step of `dt` seconds. No call within the loop, as in `StatePass`. `alone`: nothing acts on any body but what
   * all have.
   */
  all({ HEAPF32 }: Ammo, moving: MovingBodies, dt: number, alone: boolean): void {
    const { pointers, asleep, velocities } = moving;
    const { motions, accelerations, aside } = this;
    const slots = Math.min(moving.slots, motions.length);
    const half = dt / 2;
    const { unknown, other } = MOTION;
    let asideCount = 0;
    for (let slot = 0; slot < slots; slot++) {
      const pointer = pointers[slot]!;
      const motion = motions[slot]!;
      if (motion === unknown || pointer === 0 || asleep[slot] !== 0) continue;
      if (motion === other) {
        aside[asideCount++] = slot;
        continue;
      }
      const body = pointer >> 2;
      const at = slot * VELOCITY;
      const vx = velocities[at]!;
      const vy = velocities[at + 1]!;
      const vz = velocities[at + 2]!;
      const x = accelerations[slot * 3]! * dt;
      const y = accelerations[slot * 3 + 1]! * dt;
      const z = accelerations[slot * 3 + 2]! * dt;
      if (
        !same(HEAPF32[body + V]!, vx, x) ||
        !same(HEAPF32[body + V + 1]!, vy, y) ||
        !same(HEAPF32[body + V + 2]!, vz, z)
      ) {
        aside[asideCount++] = slot;
        continue;
      }
      // Mostly along one axis.
      if (x !== 0) HEAPF32[body + O]! -= x * half;
      if (y !== 0) HEAPF32[body + O + 1]! -= y * half;
      if (z !== 0) HEAPF32[body + O + 2]! -= z * half;
    }
    this.asideCount = asideCount;
    this.#leadOn(HEAPF32, moving, dt, alone);
  }

  /**
   * Nothing is to be done for who rests, or gained more speed than by what acts on it. Who was pushed evenly goes on with
   * the mean of the speeds at both ends of the step: here where all are `alone`, elsewhere as whoever looks at it says.
   */
  #leadOn(heap: Float32Array, { pointers, velocities }: MovingBodies, dt: number, alone: boolean) {
    const { motions, accelerations, aside } = this;
    let kept = 0;
    for (let i = 0; i < this.asideCount; i++) {
      const slot = aside[i]!;
      const body = pointers[slot]! >> 2;
      const at = slot * VELOCITY;
      let speed = 0;
      let change = 0;
      let most = 0;
      for (let j = 0; j < 3; j++) {
        const now = heap[body + V + j]!;
        speed += now ** 2;
        change += (now - velocities[at + j]!) ** 2;
        most += (accelerations[slot * 3 + j]! * dt) ** 2;
      }
      const falls = motions[slot] === MOTION.falls;
      if (falls && (speed < RESTING ** 2 || change > most * EVEN)) continue;
      if (falls && alone && change <= most * EVEN)
        for (let j = 0; j < 3; j++)
          heap[body + O + j]! += (-dt / 2) * (heap[body + V + j]! - velocities[at + j]!);
      else aside[kept++] = slot;
    }
    this.asideCount = kept;
  }
}
