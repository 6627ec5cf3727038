import { PARALLEL, type Flat } from './solid.js';

/** Triangles in a leaf. */
const LEAF = 4;

/** Numbers of a box: least x y z, greatest x y z. */
const BOX = 6;

/** Around the way that is being looked for, and how many of its lengths a metre is along each axis, 0 where it is none. */
const around = new Float64Array(BOX);
const perMetre = new Float64Array(3);

/** A tree of boxes around triangles, halved where their middles are: the children of node `i` are `2 i + 1` and `2 i + 2`. */
export class TriangleTree {
  /** The triangles, those of a leaf side by side. */
  readonly order: Int32Array;
  readonly #boxes: Flat;
  readonly #depth: number;
  /** The number of the first leaf. */
  readonly #first: number;
  /** Nodes that wait. */
  readonly #stack: Int32Array;
  /** Where the triangles of each leaf begin, and the last one's end. */
  readonly #leaves: Int32Array;
  /** The leaf that `next` came to. */
  from = 0;
  to = 0;
  #top = 0;
  /** How wide triangles are, metres, and whether the way is longer. */
  readonly #width: number;
  #isLong = false;

  constructor(points: Flat, index: Int32Array) {
    const count = index.length / 3;
    this.#depth = Math.max(0, Math.ceil(Math.log2(Math.max(1, count) / LEAF)));
    this.#first = 2 ** this.#depth - 1;
    this.#boxes = new Float64Array(BOX * (2 ** (this.#depth + 1) - 1));
    this.#stack = new Int32Array(this.#depth + 2);
    this.#leaves = new Int32Array(2 ** this.#depth + 1);
    this.order = Int32Array.from({ length: count }, (_, i) => i);
    const boxes = boxesOf(points, index);
    this.#width = meanWidth(boxes);
    this.#build(boxes, 0, 0, count, 0);
  }

  #build(boxes: Flat, node: number, from: number, to: number, depth: number): void {
    const own = this.#boxes.subarray(BOX * node, BOX * (node + 1));
    own.fill(Infinity, 0, 3).fill(-Infinity, 3);
    for (let i = from; i < to; i++)
      for (let k = 0; k < 3; k++) {
        const at = BOX * this.order[i]! + k;
        own[k] = Math.min(own[k]!, boxes[at]!);
        own[3 + k] = Math.max(own[3 + k]!, boxes[at + 3]!);
      }
    if (depth === this.#depth) {
      this.#leaves[node - this.#first + 1] = to;
      return;
    }
    const sizes = [0, 1, 2].map((k) => own[3 + k]! - own[k]!);
    const axis = sizes.indexOf(Math.max(...sizes));
    const middle = (triangle: number): number =>
      boxes[BOX * triangle + axis]! + boxes[BOX * triangle + 3 + axis]!;
    this.order.subarray(from, to).sort((a, b) => middle(a) - middle(b) || a - b);
    const half = (from + to) >> 1;
    this.#build(boxes, 2 * node + 1, from, half, depth + 1);
    this.#build(boxes, 2 * node + 2, half, to, depth + 1);
  }

  get box(): Flat {
    return this.#boxes.subarray(0, BOX);
  }

  /** Looks for what a way comes to. */
  start(way: Flat): void {
    const margin = way[6]!;
    this.#isLong = false;
    for (let k = 0; k < 3; k++) {
      const p = way[k]!;
      const d = way[3 + k]!;
      around[k] = (d < 0 ? p + d : p) - margin;
      around[3 + k] = (d < 0 ? p : p + d) + margin;
      if (Math.abs(d) > this.#width) this.#isLong = true;
      perMetre[k] = Math.abs(d) <= PARALLEL ? 0 : 1 / d;
    }
    this.#top = this.#comesTo(0, way) ? 1 : 0;
    this.#stack[0] = 0;
  }

  /** The next leaf to which the way comes; false: there is none. */
  next(way: Flat): boolean {
    const stack = this.#stack;
    const first = this.#first;
    let top = this.#top;
    while (top > 0) {
      const node = stack[--top]!;
      if (node >= first) {
        this.#top = top;
        this.from = this.#leaves[node - first]!;
        this.to = this.#leaves[node - first + 1]!;
        return true;
      }
      const child = 2 * node + 1;
      if (this.#comesTo(BOX * child + BOX, way)) stack[top++] = child + 1;
      if (this.#comesTo(BOX * child, way)) stack[top++] = child;
    }
    this.#top = 0;
    return false;
  }

  #comesTo(at: number, way: Flat): boolean {
    const boxes = this.#boxes;
    if (
      boxes[at]! > around[3]! ||
      boxes[at + 3]! < around[0]! ||
      boxes[at + 2]! > around[5]! ||
      boxes[at + 5]! < around[2]! ||
      boxes[at + 1]! > around[4]! ||
      boxes[at + 4]! < around[1]!
    )
      return false;
    return !this.#isLong || this.#crosses(at, way);
  }

  /** What is longer than triangles may pass by a box that the one around it meets. */
  #crosses(at: number, way: Flat): boolean {
    const boxes = this.#boxes;
    const margin = way[6]!;
    let first = 0;
    let last = way[7]!;
    for (let k = 0; k < 3; k++) {
      const share = perMetre[k]!;
      if (share === 0) continue;
      const a = (boxes[at + k]! - margin - way[k]!) * share;
      const b = (boxes[at + 3 + k]! + margin - way[k]!) * share;
      const low = share > 0 ? a : b;
      const high = share > 0 ? b : a;
      if (low > first) first = low;
      if (high < last) last = high;
    }
    return first <= last;
  }
}

/** How wide boxes are on an average, metres. */
function meanWidth(boxes: Flat): number {
  let sum = 0;
  for (let at = 0; at < boxes.length; at += BOX)
    for (let k = 0; k < 3; k++) sum += boxes[at + 3 + k]! - boxes[at + k]!;
  return sum / Math.max(1, boxes.length / 2);
}

function boxesOf(points: Flat, index: Int32Array): Flat {
  const boxes = new Float64Array(2 * index.length);
  for (let t = 0; t < index.length / 3; t++)
    for (let k = 0; k < 3; k++) {
      const a = points[3 * index[3 * t]! + k]!;
      const b = points[3 * index[3 * t + 1]! + k]!;
      const c = points[3 * index[3 * t + 2]! + k]!;
      boxes[BOX * t + k] = Math.min(a, b, c);
      boxes[BOX * t + 3 + k] = Math.max(a, b, c);
    }
  return boxes;
}
