import type { Flat } from './solid.js';

/** Numbers of a box: least x y z, greatest x y z. */
export const BOX = 6;

/** Who finds boxes that others meet. */
export interface Search {
  /** So many boxes, side by side. They stay where they are until the next call. */
  fill(boxes: Flat, count: number): void;
  /** The numbers of those that meet the first box of `box`, in no order; their count. */
  near(box: Flat, out: Int32Array): number;
}

/** Slabs along each axis. What is beyond the first or the last lies in that. */
const SLABS = 32;

/** Most boxes have their middle between these shares of all; as far beyond on either side goes the last slab. */
const MOST = 0.1;
const BEYOND = 0.5;

/** Slabs of a box: the first along each axis, and the last. */
const range = new Int32Array(BOX);

/** What lies in more slabs along x than this is asked for by all. */
const WIDE = 8;

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
  #middles: Flat = new Float64Array(0);

  fill(boxes: Flat, count: number): void {
    this.#boxes = boxes;
    const words = (count + 31) >> 5;
    this.#words = words;
    const size = 3 * SLABS * words;
    if (this.#bits.length < size) this.#bits = new Int32Array(2 * size);
    if (this.#middles.length !== count) {
      this.#middles = new Float64Array(count);
      this.#order = new Int32Array(count);
    }
    const bits = this.#bits.fill(0);
    for (let axis = 0; axis < 3; axis++) this.#spread(axis, count);
    this.#sort(count);
    for (let bit = 0; bit < count; bit++) {
      this.#look(boxes, BOX * this.#order[bit]!);
      for (let axis = 0; axis < 3; axis++)
        for (let slab = range[axis]!; slab <= range[3 + axis]!; slab++)
          bits[(axis * SLABS + slab) * words + (bit >> 5)]! |= 1 << (bit & 31);
    }
  }

  /** Slabs where most boxes are: one that falls out of the world is not to make all of them wide. */
  #spread(axis: number, count: number): void {
    const middles = this.#middles;
    for (let i = 0; i < count; i++) {
      const middle = (this.#boxes[BOX * i + axis]! + this.#boxes[BOX * i + 3 + axis]!) / 2;
      // Of what may be anywhere.
      middles[i] = middle === middle ? middle : 0;
    }
    middles.sort();
    const low = middles[Math.floor(MOST * (count - 1))] ?? 0;
    const high = middles[Math.ceil((1 - MOST) * (count - 1))] ?? 0;
    const width = (high - low) * (1 + 2 * BEYOND);
    this.#start[axis] = low - (high - low) * BEYOND;
    this.#perMetre[axis] = width > 0 ? SLABS / width : 0;
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
