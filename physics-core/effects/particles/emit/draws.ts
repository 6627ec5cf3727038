/** 2^-53: a double has so many digits between 0 and 1. */
const DIGIT = 2 ** -53;

/** Mixes all digits of a word with each other (the finalizer of MurmurHash3, by A. Appleby, public domain). */
function mixed(word: number): number {
  let bits = word;
  bits = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return bits ^ (bits >>> 16);
}

/** Odd, and without a pattern: 2^32 by the golden ratio, and by the square root of 2. */
const [GOLDEN, SILVER] = [0x9e3779b9, 0xb504f333] as const;

/**
 * Random numbers that are found by counting: those of something are the same whenever they are asked for, in whatever order,
 * in every browser. So nothing of them has to be kept from step to step.
 */
export class Draws {
  readonly #seed: number;
  #key = 0;
  #count = 0;

  constructor(seed: number) {
    this.#seed = mixed(seed | 0) ^ mixed(Math.floor(seed / 2 ** 32));
  }

  /** From here on: the numbers of the `n`-th of what a system has of a `kind`. */
  of(n: number, kind = 0): this {
    const high = Math.floor(n / 2 ** 32);
    const first = mixed(this.#seed ^ Math.imul(kind + 1, SILVER) ^ high);
    this.#key = mixed(first ^ mixed(n | 0));
    this.#count = 0;
    return this;
  }

  #word(): number {
    this.#count++;
    return mixed(this.#key + Math.imul(this.#count, GOLDEN)) >>> 0;
  }

  /** From 0 on, below 1. */
  next(): number {
    return ((this.#word() >>> 5) * 2 ** 26 + (this.#word() >>> 6)) * DIGIT;
  }

  /** From -1 on, below 1. */
  either(): number {
    return 2 * this.next() - 1;
  }
}
