import { MOVED } from '../engine/state-pass.js';

/** Numbers per pose: x y z, then the quaternion x y z w. */
export const POSE = 7;

/**
 * Poses of all bodies, a slot each: at the last step but one, at the last, and what is drawn between them.
 * All are of the body's own frame. Grows by doubling; nothing is allocated in a frame.
 */
export class Poses {
  previous = new Float64Array(POSE * 16);
  current = new Float64Array(POSE * 16);
  /** What is drawn. */
  data = new Float64Array(POSE * 16);
  /** Slots to draw; the first `movedCount` count. */
  moved = new Int32Array(16);
  movedCount = 0;
  /** What is still to be drawn of a slot: MOVED, 1 when it stands where it came to, 0 when that is drawn. */
  marks = new Uint8Array(16);
  readonly #free: number[] = [];
  #count = 0;

  take(): number {
    const slot = this.#free.pop() ?? this.#count++;
    if (slot >= this.moved.length) this.#grow();
    return slot;
  }

  release(slot: number): void {
    this.marks[slot] = 0;
    this.#free.push(slot);
  }

  #grow(): void {
    const room = this.moved.length * 2;
    const larger = (old: Float64Array): Float64Array<ArrayBuffer> => {
      const grown = new Float64Array(room * POSE);
      grown.set(old);
      return grown;
    };
    this.previous = larger(this.previous);
    this.current = larger(this.current);
    this.data = larger(this.data);
    const marks = new Uint8Array(room);
    marks.set(this.marks);
    this.marks = marks;
    this.moved = new Int32Array(room);
  }

  /** The body will be drawn in the next frame. */
  mark(slot: number): void {
    this.marks[slot] = MOVED;
  }

  /** A jump: nothing lies between the old pose and the new one. */
  snap(slot: number): void {
    const at = slot * POSE;
    for (let i = at; i < at + POSE; i++) this.previous[i] = this.current[i]!;
    this.mark(slot);
  }

  /** A step begins: it starts where the last one ended. */
  shift(): void {
    this.previous.set(this.current);
    const { marks } = this;
    for (let slot = 0; slot < this.#count; slot++) if (marks[slot] === MOVED) marks[slot] = 1;
  }

  /** Fills `data` and `moved`: `fraction` 0 is the last step but one, 1 the last. */
  interpolate(fraction: number): void {
    this.movedCount = 0;
    for (let slot = 0; slot < this.#count; slot++) {
      if (!this.marks[slot]) continue;
      this.#between(slot * POSE, fraction);
      this.moved[this.movedCount++] = slot;
      if (fraction >= 1 || this.marks[slot] === 1) this.marks[slot] = 0;
    }
  }

  /** Straight line for the position, normalised line for the quaternion (the angle per step is small). */
  #between(at: number, f: number): void {
    const { previous: a, current: b, data: out } = this;
    for (let i = at; i < at + 3; i++) out[i] = a[i]! + (b[i]! - a[i]!) * f;
    const q = at + 3;
    const cosine =
      a[q]! * b[q]! + a[q + 1]! * b[q + 1]! + a[q + 2]! * b[q + 2]! + a[q + 3]! * b[q + 3]!;
    const sign = cosine < 0 ? -f : f;
    let size = 0;
    for (let i = q; i < q + 4; i++) {
      out[i] = a[i]! * (1 - f) + b[i]! * sign;
      size += out[i]! * out[i]!;
    }
    const s = 1 / Math.sqrt(size);
    for (let i = q; i < q + 4; i++) out[i]! *= s;
  }
}
