import { grown, grownInt } from '../base/grown.js';

/** Numbers per velocity: linear, then angular. */
export const VELOCITY = 6;

/** What passes over all bodies ask of each, by slot: side by side in memory, so that a body costs nanoseconds. */
export class MovingBodies {
  /** One more than the highest slot that was ever taken. */
  slots = 0;
  /** How often one of them became another: it came or went, or has another size, mass or gravity. */
  reviews = 0;
  /** Of the btRigidBody on the heap, where Bullet moves it; 0 elsewhere. */
  pointers = new Int32Array(16);
  /** 1 for those that were put to sleep: Bullet may have woken them since. */
  asleep = new Uint8Array(16);
  /** World frame, as they were read last: at the end of the last step, or after an edit. */
  velocities = new Float64Array(16 * VELOCITY);
  /** Squares of ways, m²: who goes farther in a step is looked at by itself. NaN: so is who sleeps, or is not known yet. */
  limits = new Float64Array(16);
  /** Squares of turns, rad²: the same of who turns farther. */
  turnLimits = new Float64Array(16);

  /** A slot that is free: nothing is known of it. */
  take(slot: number): void {
    if (slot >= this.pointers.length) this.#grow(slot);
    this.slots = Math.max(this.slots, slot + 1);
    this.pointers[slot] = 0;
    this.asleep[slot] = 0;
    this.limits[slot] = NaN;
    this.stop(slot);
  }

  stop(slot: number): void {
    this.velocities.fill(0, slot * VELOCITY, (slot + 1) * VELOCITY);
  }

  #grow(slot: number): void {
    const room = Math.max(2 * this.pointers.length, slot + 1);
    this.pointers = grownInt(this.pointers, room);
    this.velocities = grown(this.velocities, room * VELOCITY);
    this.limits = grown(this.limits, room);
    this.turnLimits = grown(this.turnLimits, room);
    const asleep = new Uint8Array(room);
    asleep.set(this.asleep);
    this.asleep = asleep;
  }
}
