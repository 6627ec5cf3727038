import { BOX } from './layout.js';

/** Triangles in a leaf. */
const LEAF = 4;

/** A tree of boxes around triangles, as flat arrays: node `i` has its children at `2 i + 1` and `2 i + 2`. */
export class BoxTree {
  readonly #boxes: Float64Array;
  /** The triangles, those of a leaf side by side. */
  readonly #order: Int32Array;
  readonly #depth: number;
  readonly #stack = new Int32Array(256);

  /** `boxes`: one per triangle. */
  constructor(boxes: Float64Array) {
    const count = boxes.length / BOX;
    this.#depth = Math.max(0, Math.ceil(Math.log2(Math.max(1, count) / LEAF)));
    this.#boxes = new Float64Array(BOX * (2 ** (this.#depth + 1) - 1));
    this.#order = Int32Array.from({ length: count }, (_, i) => i);
    this.#build(boxes, 0, 0, count, 0);
  }

  #build(boxes: Float64Array, node: number, from: number, to: number, depth: number): void {
    const own = this.#boxes.subarray(BOX * node, BOX * (node + 1));
    own.fill(Infinity, 0, 3).fill(-Infinity, 3);
    for (let i = from; i < to; i++)
      for (let k = 0; k < 3; k++) {
        const at = BOX * this.#order[i]! + k;
        own[k] = Math.min(own[k]!, boxes[at]!);
        own[3 + k] = Math.max(own[3 + k]!, boxes[at + 3]!);
      }
    if (depth === this.#depth) return;
    const sizes = [0, 1, 2].map((k) => own[3 + k]! - own[k]!);
    const axis = sizes.indexOf(Math.max(...sizes));
    const middle = (triangle: number) =>
      boxes[BOX * triangle + axis]! + boxes[BOX * triangle + 3 + axis]!;
    this.#order.subarray(from, to).sort((a, b) => middle(a) - middle(b));
    const half = splitAt(from, to);
    this.#build(boxes, 2 * node + 1, from, half, depth + 1);
    this.#build(boxes, 2 * node + 2, half, to, depth + 1);
  }

  /** The triangles of leaves that a box meets go to `out`; their count, no more than there is room for. */
  find(box: Float64Array, out: Int32Array): number {
    const stack = this.#stack;
    let [found, top] = [0, 0];
    // Of each node its number, depth, and its triangles.
    let used = push(stack, top, 0, 0, 0, this.#order.length);
    top = used;
    while (top > 0) {
      top -= 4;
      const [node, depth, from, to] = [
        stack[top]!,
        stack[top + 1]!,
        stack[top + 2]!,
        stack[top + 3]!,
      ];
      if (!this.#meets(node, box)) continue;
      if (depth === this.#depth) {
        for (let i = from; i < to && found < out.length; i++) out[found++] = this.#order[i]!;
        continue;
      }
      const half = splitAt(from, to);
      used = push(stack, top, 2 * node + 2, depth + 1, half, to);
      top = push(stack, used, 2 * node + 1, depth + 1, from, half);
    }
    return found;
  }

  #meets(node: number, box: Float64Array): boolean {
    const at = BOX * node;
    for (let k = 0; k < 3; k++)
      if (this.#boxes[at + k]! > box[3 + k]! || this.#boxes[at + 3 + k]! < box[k]!) return false;
    return true;
  }
}

const splitAt = (from: number, to: number): number => (from + to) >> 1;

function push(
  stack: Int32Array,
  top: number,
  node: number,
  depth: number,
  from: number,
  to: number,
): number {
  stack[top] = node;
  stack[top + 1] = depth;
  stack[top + 2] = from;
  stack[top + 3] = to;
  return top + 4;
}
