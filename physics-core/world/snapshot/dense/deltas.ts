// Whole numbers of which most are small, in few bytes: of each a code of four bits says how many bytes it takes, or how many
// zeros follow.

/** Codes from here on stand for zeros: so many that they are powers of two. */
const ZEROS = 5;
const MOST_ZEROS = 10;

/** So that what is near 0 on either side is small: 0, -1, 1, -2, 2 … */
const folded = (word: number): number => ((word << 1) ^ (word >> 31)) >>> 0;
const unfolded = (value: number): number => (value >>> 1) ^ -(value & 1);

function sizeOf(value: number): number {
  if (value < 0x10000) return value < 0x100 ? 1 : 2;
  return value < 0x1000000 ? 3 : 4;
}

/** Room for four bytes of each, and a code. */
export class DeltaWriter {
  #codes = new Uint8Array(0);
  #bytes = new Uint8Array(0);
  #codeCount = 0;
  #byteCount = 0;
  #zeros = 0;

  /** For at most so many numbers. */
  begin(count: number): void {
    if (this.#codes.length < count) {
      this.#codes = new Uint8Array(2 * count);
      this.#bytes = new Uint8Array(8 * count);
    }
    this.#codeCount = this.#byteCount = this.#zeros = 0;
  }

  put(word: number): void {
    if (word === 0) {
      this.#zeros++;
      return;
    }
    if (this.#zeros > 0) this.#putZeros();
    const value = folded(word);
    const size = sizeOf(value);
    this.#codes[this.#codeCount++] = size;
    let at = this.#byteCount;
    for (let bits = 0; bits < 8 * size; bits += 8) this.#bytes[at++] = value >>> bits;
    this.#byteCount = at;
  }

  putAll(words: Int32Array): void {
    let zeros = this.#zeros;
    for (let i = 0; i < words.length; i++) {
      if (words[i] === 0) zeros++;
      else {
        this.#zeros = zeros;
        this.put(words[i]!);
        zeros = 0;
      }
    }
    this.#zeros = zeros;
  }

  #putZeros(): void {
    for (let power = MOST_ZEROS; power >= 0; power--)
      for (; this.#zeros >= 1 << power; this.#zeros -= 1 << power)
        this.#codes[this.#codeCount++] = ZEROS + power;
  }

  /** All that was put, the codes first, two in a byte. */
  end(): Uint8Array {
    this.#putZeros();
    const codes = this.#codes;
    const half = Math.ceil(this.#codeCount / 2);
    codes[this.#codeCount] = 0;
    const all = new Uint8Array(4 + half + this.#byteCount);
    new DataView(all.buffer).setUint32(0, half, true);
    for (let i = 0; i < half; i++) all[4 + i] = codes[2 * i]! | (codes[2 * i + 1]! << 4);
    all.set(this.#bytes.subarray(0, this.#byteCount), 4 + half);
    return all;
  }
}

/** Reads them in the same order, and throws where there are no more. */
export class DeltaReader {
  readonly #all: Uint8Array;
  readonly #ofBytes: number;
  #code = 0;
  #byte: number;
  #zeros = 0;

  constructor(all: Uint8Array) {
    this.#all = all;
    this.#ofBytes = 8 + 2 * new DataView(all.buffer, all.byteOffset).getUint32(0, true);
    this.#code = 8;
    this.#byte = this.#ofBytes / 2;
  }

  next(): number {
    if (this.#zeros > 0) {
      this.#zeros--;
      return 0;
    }
    if (this.#code >= this.#ofBytes || this.#byte > this.#all.length)
      throw new RangeError('there are no more numbers');
    const pair = this.#all[this.#code >> 1]!;
    const code = this.#code++ & 1 ? pair >> 4 : pair & 15;
    if (code >= ZEROS) {
      this.#zeros = (1 << (code - ZEROS)) - 1;
      return 0;
    }
    let value = 0;
    for (let k = 0; k < code; k++) value |= this.#all[this.#byte++]! << (8 * k);
    return unfolded(value >>> 0);
  }

  takeAll(words: Int32Array): void {
    for (let i = 0; i < words.length; i++) {
      words[i] = this.next();
      const zeros = Math.min(this.#zeros, words.length - 1 - i);
      words.fill(0, i + 1, i + 1 + zeros);
      this.#zeros -= zeros;
      i += zeros;
    }
  }

  /** Whether nothing is left. */
  get done(): boolean {
    return this.#byte === this.#all.length;
  }
}
