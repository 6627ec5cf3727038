import type { Vec3 } from '../fields/types.js';
import { MOVED } from '../engine/state-pass.js';

/** Numbers per pose: x y z, then the quaternion x y z w. */
export const POSE = 7;

/**
 * Poses of all bodies, a slot each: at the last step but one, at the last, and what is drawn between them. The first two
 * are in Bullet's world, what is drawn is in its author's. All are of the body's own frame. Grows by doubling; nothing is allocated in a frame.
 */
export class Poses {
  /**
   * Where Bullet's 0 0 0 lies in its author's world, metres. Bullet counts in single precision, which has steps of 1 mm at
   * 10 km: what is far from the author's 0 0 0 is near to Bullet's.
   */
  origin: Vec3 = [0, 0, 0];
  previous = new Float64Array(POSE * 16);
  current = new Float64Array(POSE * 16);
  /** What is drawn. */
  data = new Float64Array(POSE * 16);
  /** Slots to draw; the first `movedCount` count. */
  moved = new Int32Array(16);
  movedCount = 0;
  /** Where between the last two steps `data` is. */
  fraction = 1;
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

  /**
   * Fills `data` and `moved`: `fraction` 0 is the last step but one, 1 the last. Straight line for the position, normalised
   * line for the quaternion (the angle per step is small). No call within the loop, and all is read before anything is
   * written: a body takes half as long.
   */
  interpolate(fraction: number): void {
    this.fraction = fraction;
    const [ox, oy, oz] = this.origin;
    const { previous: a, current: b, data: out, marks, moved } = this;
    const rest = 1 - fraction;
    let count = 0;
    for (let slot = 0, slots = this.#count; slot < slots; slot++) {
      const mark = marks[slot]!;
      if (mark === 0) continue;
      moved[count++] = slot;
      if (fraction >= 1 || mark === 1) marks[slot] = 0;
      const at = slot * POSE;
      const px = a[at]!;
      const py = a[at + 1]!;
      const pz = a[at + 2]!;
      const ax = a[at + 3]!;
      const ay = a[at + 4]!;
      const az = a[at + 5]!;
      const aw = a[at + 6]!;
      const qx = b[at]!;
      const qy = b[at + 1]!;
      const qz = b[at + 2]!;
      const bx = b[at + 3]!;
      const by = b[at + 4]!;
      const bz = b[at + 5]!;
      const bw = b[at + 6]!;
      const sign = ax * bx + ay * by + az * bz + aw * bw < 0 ? -fraction : fraction;
      const x = ax * rest + bx * sign;
      const y = ay * rest + by * sign;
      const z = az * rest + bz * sign;
      const w = aw * rest + bw * sign;
      const s = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
      out[at] = ox + px + (qx - px) * fraction;
      out[at + 1] = oy + py + (qy - py) * fraction;
      out[at + 2] = oz + pz + (qz - pz) * fraction;
      out[at + 3] = x * s;
      out[at + 4] = y * s;
      out[at + 5] = z * s;
      out[at + 6] = w * s;
    }
    this.movedCount = count;
  }
}
