import type { Flat } from './solid.js';

/** Numbers of a box: least x y z, greatest x y z. */
export const BOX = 6;

/** Who finds boxes that others meet. */
export interface Search {
  /** So many boxes, side by side. They stay where they are until the next call. */
  fill(boxes: Flat, count: number): void;
  /** The numbers of those that meet the first box of `box`, in no order; their count. */
  near(box: Flat, out: Int32Array): number;
  /** False: none of them meets it. For a tenth of the time. */
  any(box: Flat): boolean;
}

/** Slabs along each axis, as many as a number has bits. What is beyond the first or the last lies in that. */
const SLABS = 32;

/** Most boxes begin above, and end below, such a share of all; half as far again on either side goes the last slab. */
const MOST = 0.1;
const BEYOND = 0.5;

/** Slabs of a box: the first along each axis, and the last. */
const range = new Int32Array(BOX);

/** What lies in more slabs along x than this is asked for by all. */
const WIDE = 8;

const bitsFrom = (first: number, last: number): number => (-1 << first) & (-1 >>> (31 - last));

/**
 * Space is cut into slabs along each axis, and each has a bit for each box that lies in it: what meets a box is what has its
 * bit in a slab of all three. That asks for no cells, however wide the world or a floor in it is. Boxes have their bits in
 * the order in which they lie along x, so that few words have any of a slab.
 */
export class Slabs implements Search {
  #boxes: Flat = new Float64Array(0);
  /** Words of bits per slab, and how many of them have any of what is wide. */
  #words = 0;
  #wideWords = 0;
  /** Of each axis the slabs, of each slab the words. */
  #bits = new Int32Array(0);
  /** Of each bit the box. */
  #order = new Int32Array(0);
  /** Of each slab along x the words, from the first to before the last, that have any of what is not wide. */
  readonly #from = new Int32Array(SLABS);
  readonly #to = new Int32Array(SLABS);
  /** Of each axis where the first slab begins, and slabs per metre. */
  readonly #start = new Float64Array(3);
  readonly #perMetre = new Float64Array(3);
  /** As many as there are boxes, to be ranked, in room for more: how many move is another number in each step. */
  #numbers: Flat = new Float64Array(0);
  #room: Flat = new Float64Array(0);
  /** Of each slab along y and each along z the slabs along x in which anything lies there, a bit each. */
  readonly #rows = new Int32Array(SLABS * SLABS);

  fill(boxes: Flat, count: number): void {
    this.#boxes = boxes;
    const words = (count + 31) >> 5;
    this.#words = words;
    const size = 3 * SLABS * words;
    if (this.#bits.length < size) this.#bits = new Int32Array(2 * size);
    if (this.#order.length < count) {
      this.#order = new Int32Array(2 * count);
      this.#room = new Float64Array(2 * count);
    }
    if (this.#numbers.length !== count) this.#numbers = this.#room.subarray(0, count);
    const bits = this.#bits.fill(0);
    this.#rows.fill(0);
    for (let axis = 0; axis < 3; axis++) this.#spread(axis, count);
    this.#sort(count);
    for (let bit = 0; bit < count; bit++) {
      this.#look(boxes, BOX * this.#order[bit]!);
      this.#note();
      for (let axis = 0; axis < 3; axis++)
        for (let slab = range[axis]!; slab <= range[3 + axis]!; slab++)
          bits[(axis * SLABS + slab) * words + (bit >> 5)]! |= 1 << (bit & 31);
    }
  }

  /** Something lies in `range`. */
  #note(): void {
    const along = bitsFrom(range[0]!, range[3]!);
    for (let y = range[1]!; y <= range[4]!; y++)
      for (let z = range[2]!; z <= range[5]!; z++) this.#rows[SLABS * y + z]! |= along;
  }

  any(box: Flat): boolean {
    this.#look(box, 0);
    const along = bitsFrom(range[0]!, range[3]!);
    const rows = this.#rows;
    for (let y = range[1]!; y <= range[4]!; y++)
      for (let z = range[2]!; z <= range[5]!; z++)
        if ((rows[SLABS * y + z]! & along) !== 0) return true;
    return false;
  }

  /** Slabs where most boxes begin to where most end: one that falls out of the world is not to make all of them wide. */
  #spread(axis: number, count: number): void {
    const low = this.#ranked(axis, count, MOST);
    const high = this.#ranked(3 + axis, count, 1 - MOST);
    const reach = Math.max(0, high - low);
    this.#start[axis] = low - reach * BEYOND;
    this.#perMetre[axis] = reach > 0 ? SLABS / (reach * (1 + 2 * BEYOND)) : 0;
  }

  /** The number of boxes below which such a share of all have theirs. */
  #ranked(which: number, count: number, share: number): number {
    const numbers = this.#numbers;
    for (let i = 0; i < count; i++) {
      const number = this.#boxes[BOX * i + which]!;
      // Of what may be anywhere.
      numbers[i] = Number.isFinite(number) ? number : 0;
    }
    numbers.sort();
    return numbers[Math.floor(share * (count - 1))] ?? 0;
  }

  /** First what is wide, then by the slab along x in which a box begins. */
  #sort(count: number): void {
    const from = this.#from.fill(0);
    const to = this.#to.fill(0);
    let wide = 0;
    for (let i = 0; i < count; i++) {
      const slab = this.#narrow(i);
      if (slab < 0) this.#order[wide++] = i;
      else to[slab]!++;
    }
    this.#wideWords = (wide + 31) >> 5;
    let before = wide;
    for (let slab = 0; slab < SLABS; slab++) {
      from[slab] = before;
      before += to[slab]!;
      to[slab] = from[slab]!;
    }
    for (let i = 0; i < count; i++) {
      const slab = this.#narrow(i);
      if (slab >= 0) this.#order[to[slab]!++] = i;
    }
    // What lies in a slab begins no more than so many before it.
    for (let slab = SLABS - 1; slab >= 0; slab--) {
      from[slab] = from[Math.max(0, slab - WIDE + 1)]! >> 5;
      to[slab] = (to[slab]! + 31) >> 5;
    }
  }

  /** The slab along x in which a box begins; -1: it is wide. */
  #narrow(i: number): number {
    this.#look(this.#boxes, BOX * i);
    return range[3]! - range[0]! < WIDE ? range[0]! : -1;
  }

  /** The first and the last slab of a box along each axis, into `range`. */
  #look(boxes: Flat, at: number): void {
    for (let axis = 0; axis < 3; axis++) {
      const start = this.#start[axis]!;
      const perMetre = this.#perMetre[axis]!;
      const low = (boxes[at + axis]! - start) * perMetre;
      const high = (boxes[at + 3 + axis]! - start) * perMetre;
      range[axis] = low > 0 ? (low < SLABS ? low : SLABS - 1) : 0;
      range[3 + axis] = high > 0 ? (high < SLABS ? high : SLABS - 1) : 0;
    }
  }

  near(box: Flat, out: Int32Array): number {
    const words = this.#words;
    this.#look(box, 0);
    const first = range[0]!;
    const last = range[3]!;
    const x0 = first * words;
    const x1 = last * words;
    const y0 = (SLABS + range[1]!) * words;
    const y1 = (SLABS + range[4]!) * words;
    const z0 = (2 * SLABS + range[2]!) * words;
    const z1 = (2 * SLABS + range[5]!) * words;
    const bits = this.#bits;
    const boxes = this.#boxes;
    const order = this.#order;
    const wide = this.#wideWords;
    const from = this.#from[first]!;
    const to = this.#to[last]!;
    let found = 0;
    for (let word = wide > 0 ? 0 : from; word < to || word < wide; word++) {
      if (word >= wide && word < from) word = from;
      if (word >= words) break;
      let any = bits[y0 + word]!;
      for (let y = y0 + words; y <= y1; y += words) any |= bits[y + word]!;
      let along = bits[x0 + word]!;
      for (let x = x0 + words; x <= x1; x += words) along |= bits[x + word]!;
      any &= along;
      along = bits[z0 + word]!;
      for (let z = z0 + words; z <= z1; z += words) along |= bits[z + word]!;
      any &= along;
      while (any !== 0) {
        const bit = 31 - Math.clz32(any);
        any ^= 1 << bit;
        const i = order[32 * word + bit]!;
        const at = BOX * i;
        if (
          boxes[at + 4]! >= box[1]! &&
          boxes[at + 1]! <= box[4]! &&
          boxes[at]! <= box[3]! &&
          boxes[at + 3]! >= box[0]! &&
          boxes[at + 2]! <= box[5]! &&
          boxes[at + 5]! >= box[2]!
        )
          out[found++] = i;
      }
    }
    return found;
  }
}
