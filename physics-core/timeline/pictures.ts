import { POSE } from '../dynamics/poses.js';

/** A body, as far as pictures show it. */
interface Shown {
  readonly id: number;
  readonly slot: number;
}

/** The end of a step. */
export interface Moment {
  readonly step: number;
  /** Simulated seconds. */
  readonly time: number;
  /** Whether its picture shows all bodies, or those that moved since the last one. */
  readonly whole: boolean;
}

interface Picture extends Moment {
  readonly ids: Int32Array;
  /** Seen from Bullet's origin, in single precision, as Bullet has them. */
  readonly poses: Float32Array;
}

/** Where bodies were, in pictures; each that is whole can be shown without those before it. */
export class Pictures {
  readonly #all: Picture[] = [];
  /** Of each slot: whose pose was taken last, and which. */
  #ids = new Int32Array(0);
  #last = new Float32Array(0);

  get length(): number {
    return this.#all.length;
  }

  at(i: number): Moment {
    return this.#all[i]!;
  }

  /** Without what they show. */
  get moments(): Moment[] {
    return this.#all.map(({ step, time, whole }) => ({ step, time, whole }));
  }

  /** `poses`: of all slots, seen from Bullet's origin. */
  add(moment: Moment, bodies: readonly Shown[], poses: Float64Array): void {
    this.#makeRoom(poses.length);
    const moved = bodies.filter((body) => this.#take(body, poses) || moment.whole);
    const picture = {
      ...moment,
      ids: Int32Array.from(moved, ({ id }) => id),
      poses: new Float32Array(moved.length * POSE),
    };
    moved.forEach(({ slot }, i) => picture.poses.set(this.#lastOf(slot), i * POSE));
    this.#all.push(picture);
  }

  #makeRoom(numbers: number): void {
    if (this.#last.length >= numbers) return;
    const last = new Float32Array(numbers);
    last.set(this.#last);
    const ids = new Int32Array(numbers / POSE);
    ids.set(this.#ids);
    this.#last = last;
    this.#ids = ids;
  }

  #lastOf(slot: number): Float32Array {
    return this.#last.subarray(slot * POSE, (slot + 1) * POSE);
  }

  /** Whether it is elsewhere than it was when it was looked at last. */
  #take({ id, slot }: Shown, from: Float64Array): boolean {
    let moved = this.#ids[slot] !== id;
    this.#ids[slot] = id;
    for (let i = slot * POSE, end = i + POSE; i < end; i++) {
      const now = Math.fround(from[i]!);
      if (this.#last[i] === now) continue;
      this.#last[i] = now;
      moved = true;
    }
    return moved;
  }

  /** The number of the first picture that is not before a step or time; of the last and one where all are. */
  firstFrom(what: 'step' | 'time', value: number): number {
    let low = 0;
    let high = this.#all.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#all[middle]![what] < value) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The number of the picture that is nearest to a time. */
  nearest(time: number): number {
    const after = Math.min(this.firstFrom('time', time), this.#all.length - 1);
    const before = this.#all[after - 1];
    return before && time - before.time < this.#all[after]!.time - time ? after - 1 : after;
  }

  /** Says where each body was: the last picture that has it, of those since all were shown. */
  show(at: number, put: (id: number, pose: Float32Array) => void): void {
    const said = new Set<number>();
    for (let i = at; i >= 0; i--) {
      const { ids, poses, whole } = this.#all[i]!;
      for (let k = 0; k < ids.length; k++) {
        const id = ids[k]!;
        if (said.has(id)) continue;
        said.add(id);
        put(id, poses.subarray(k * POSE, (k + 1) * POSE));
      }
      if (whole) return;
    }
  }

  /** Those of steps after one have not been. */
  cut(after: number): void {
    while (this.#all.length > 0 && this.#all.at(-1)!.step > after) this.#all.pop();
    this.#ids.fill(0);
  }

  /** Those of steps before are kept no more. */
  drop(before: number): void {
    this.#all.splice(0, this.firstFrom('step', before));
  }
}
