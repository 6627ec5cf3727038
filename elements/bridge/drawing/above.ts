import { copyInto, identity, invert, multiply, type Affine } from '../geometry/matrix.js';
import { fromX3D } from '../x3dom/matrices.js';
import type { X3DNode } from '../x3dom/x3dom.js';

// Scratch: nothing is allocated while bodies move.
const world: Affine = identity();
const factor: Affine = identity();
const product: Affine = identity();

/** What stands above nodes that are written one after another: for brothers it is worked out once. */
export class Above {
  #parent: X3DNode | undefined;
  /** Of all that places what stands below. */
  readonly #placing: X3DNode[] = [];
  readonly #inverse: Affine = identity();

  /** From the world into the frame of what stands in a node; undefined where that is the world's own. */
  inverseIn(parent: X3DNode | undefined): Affine | undefined {
    if (parent !== this.#parent) this.#read(parent);
    return this.#placing.length > 0 ? this.#inverse : undefined;
  }

  #read(parent: X3DNode | undefined): void {
    this.forget();
    this.#parent = parent;
    for (let at = parent; at; at = at._parentNodes[0]) {
      if (!at._trafo) continue;
      if (this.#placing.push(at) === 1) fromX3D(at._trafo, world);
      else copyInto(multiply(fromX3D(at._trafo, factor), world, product), world);
    }
    if (this.#placing.length > 0) invert(world, this.#inverse);
  }

  /** A node has another matrix now. */
  moved(node: X3DNode): void {
    if (this.#placing.length > 0 && this.#placing.includes(node)) this.forget();
  }

  /** Anything may stand elsewhere by now. */
  forget(): void {
    this.#parent = undefined;
    this.#placing.length = 0;
  }
}
