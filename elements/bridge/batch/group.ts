import type { X3DBounded } from '../x3dom/renderer.js';
import type { X3DNode } from '../x3dom/x3dom.js';

/**
 * A group some of whose Transforms are drawn by batches. x3dom passes its children one by one in each frame, to draw them
 * and to know their bounds: it is shown only the others, batches among them.
 */
export class Group {
  readonly node: X3DBounded;
  readonly #batched = new Set<X3DNode>();
  #others: X3DNode[] | undefined;
  /** How many children there were when the others were last looked for. */
  #children = 0;

  constructor(node: X3DBounded) {
    this.node = node;
    const { collectDrawableObjects, getVolume, nodeChanged } = node;
    node.collectDrawableObjects = (...way) =>
      this.#showOthers(() => collectDrawableObjects.apply(node, way));
    node.nodeChanged = (field) => {
      nodeChanged.call(node, field);
      this.#others = undefined;
    };
    node.getVolume = () =>
      node.volumeValid() ? node._graph.volume : this.#showOthers(() => getVolume.call(node));
  }

  add(child: X3DNode): void {
    this.#batched.add(child);
    this.#others = undefined;
  }

  delete(child: X3DNode): void {
    this.#batched.delete(child);
    this.#others = undefined;
  }

  #showOthers<T>(look: () => T): T {
    const { node } = this;
    const all = node._childNodes;
    if (this.#children !== all.length) this.#others = undefined;
    this.#children = all.length;
    node._childNodes = this.#others ??= all.filter((child) => !this.#batched.has(child));
    try {
      return look();
    } finally {
      node._childNodes = all;
    }
  }
}
