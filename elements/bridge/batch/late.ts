import type { Row } from '../drawing/drawing.js';
import { identity, type Affine } from '../geometry/matrix.js';
import { placeNode } from '../x3dom/placing.js';
import type { X3DMatrix, X3DNode } from '../x3dom/x3dom.js';
import type { X3DTransform } from '../x3dom/renderer.js';

/** In the place of an object: whoever reads or writes anything of it has `settle` called first. */
const standInFor = <T extends object>(object: T, settle: () => void): T =>
  new Proxy(object, {
    get: (own, name) => (settle(), Reflect.get(own, name)),
    set: (own, name, value) => (settle(), Reflect.set(own, name, value)),
    ownKeys: (own) => (settle(), Reflect.ownKeys(own)),
  });

/**
 * Where a Transform is that x3dom does not draw: its matrix and its fields are written when somebody reads them, be it
 * x3dom, a ROUTE or a script. Until then others stand in for both.
 */
export class Late implements Row {
  readonly node: X3DTransform;
  readonly parent: X3DNode | undefined;
  readonly pose: Affine = identity();
  #linear: number[] | undefined;
  readonly #onmove: (pose: Affine, linear: number[] | undefined) => void;
  readonly #fields: X3DTransform['_vf'];
  readonly #lateFields: X3DTransform['_vf'];
  /** The one that stands in knows which one it stands in for: x3dom makes another one with each edit. */
  #matrix: X3DMatrix;
  #lateMatrix: X3DMatrix;
  #isLate = false;

  constructor(node: X3DTransform, onmove: (pose: Affine, linear: number[] | undefined) => void) {
    this.node = node;
    [this.parent] = node._parentNodes;
    this.#onmove = onmove;
    this.#fields = node._vf;
    this.#lateFields = standInFor(this.#fields, this.settle);
    this.#matrix = node._trafo;
    this.#lateMatrix = standInFor(this.#matrix, this.settle);
  }

  moved(linear: number[] | undefined): void {
    this.#linear = linear;
    if (!this.#isLate) this.#begin();
    this.#onmove(this.pose, linear);
  }

  #begin(): void {
    const { node } = this;
    this.#isLate = true;
    if (node._trafo !== this.#matrix) {
      this.#matrix = node._trafo;
      this.#lateMatrix = standInFor(this.#matrix, this.settle);
    }
    node._trafo = this.#lateMatrix;
    node._vf = this.#lateFields;
  }

  /** All of it is there, as it would be if x3dom drew it. */
  readonly settle = (): void => {
    if (!this.#isLate) return;
    this.#isLate = false;
    this.node._trafo = this.#matrix;
    this.node._vf = this.#fields;
    placeNode(this.node, this.pose, this.#linear);
  };
}
