import { doublesOf, pack } from '../../base/packed.js';

/** Numbers of each particle: x y z, metres, and vx vy vz, m/s. */
export const PARTICLE = 6;

/** For a snapshot: each column as packed numbers. */
export interface KeptCloud {
  motion: string;
  born: string;
  ends: string;
  numbers: string;
}

/** The living particles of a system, the oldest first, as flat numbers. */
export class Cloud {
  count = 0;
  /** PARTICLE numbers each. */
  motion = new Float64Array(0);
  /** When each was born, and when it dies, seconds of its system. */
  born = new Float64Array(0);
  ends = new Float64Array(0);
  /** Its number among all that its system ever made: what is drawn at random for it goes by that. */
  numbers = new Float64Array(0);
  /** 1: the last step left it as it was. */
  still = new Uint8Array(0);

  clear(): void {
    this.count = 0;
  }

  /** So many stay, at most: the youngest. */
  keep(most: number): void {
    const over = this.count - most;
    if (over <= 0) return;
    for (let k = over; k < this.count; k++) this.move(k, k - over);
    this.count = most;
  }

  /** One more; returns where it stands. */
  add(): number {
    const k = this.count++;
    if (k >= this.born.length) this.#grow();
    this.still[k] = 0;
    return k;
  }

  #grow(): void {
    const room = Math.max(16, 2 * this.born.length);
    const grown = (old: Float64Array, width: number): Float64Array<ArrayBuffer> => {
      const larger = new Float64Array(room * width);
      larger.set(old);
      return larger;
    };
    this.motion = grown(this.motion, PARTICLE);
    this.born = grown(this.born, 1);
    this.ends = grown(this.ends, 1);
    this.numbers = grown(this.numbers, 1);
    const still = new Uint8Array(room);
    still.set(this.still);
    this.still = still;
  }

  /** Becomes as others are seen: PARTICLE numbers of each, and when it was born. */
  show(motion: ArrayLike<number>, born: ArrayLike<number>): void {
    this.clear();
    while (this.count < born.length) this.add();
    this.motion.set(motion);
    this.born.set(born);
  }

  /** The `from`-th stands in place `to` from now on. */
  move(from: number, to: number): void {
    if (from === to) return;
    this.motion.copyWithin(to * PARTICLE, from * PARTICLE, (from + 1) * PARTICLE);
    this.born[to] = this.born[from]!;
    this.ends[to] = this.ends[from]!;
    this.numbers[to] = this.numbers[from]!;
    this.still[to] = this.still[from]!;
  }

  // ---- going back -------------------------------------------------------------------------------------------------

  save(): KeptCloud {
    const { count } = this;
    return {
      motion: pack(this.motion.subarray(0, count * PARTICLE)),
      born: pack(this.born.subarray(0, count)),
      ends: pack(this.ends.subarray(0, count)),
      numbers: pack(this.numbers.subarray(0, count)),
    };
  }

  load(kept: KeptCloud): void {
    this.show(doublesOf(kept.motion), doublesOf(kept.born));
    this.ends.set(doublesOf(kept.ends));
    this.numbers.set(doublesOf(kept.numbers));
  }
}
