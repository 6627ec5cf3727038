import type { X3DBounded } from '../x3dom/renderer.js';
import type { X3DNode } from '../x3dom/x3dom.js';

/**
 * A group some of whose Transforms are drawn by batches. x3dom passes its children one by one in each frame, to draw them
 * and to know their bounds: it is shown only the others, batches among them.
 */
export class Group {
  readonly node: X3DBounded;
  readonly #batched = new Set<X3DNode>();
  #others: X3DNode[];
  /** How many children there were when the others were last right. */
  #children: number;

  constructor(node: X3DBounded) {
    this.node = node;
    this.#others = [...node._childNodes];
    this.#children = node._childNodes.length;
    this.#behave(node);
  }

  #behave(node: X3DBounded): void {
    const { collectDrawableObjects, getVolume, addChild, removeChild } = node;
    node.collectDrawableObjects = (...way) =>
      this.#showOthers(() => collectDrawableObjects.apply(node, way));
    node.getVolume = () =>
      node.volumeValid() ? node._graph.volume : this.#showOthers(() => getVolume.call(node));
    node.addChild = (child, ...rest) => {
      const before = node._childNodes.length;
      const added = addChild.call(node, child, ...rest);
      if (node._childNodes.length > before) this.#came(child);
      return added;
    };
    node.removeChild = (child, ...rest) => {
      const removed = removeChild.call(node, child, ...rest);
      if (removed) this.#went(child);
      return removed;
    };
  }

  #came(child: X3DNode): void {
    this.#children++;
    this.#others.push(child);
  }

  #went(child: X3DNode): void {
    this.#children--;
    this.#without(child);
  }

  /** What comes is the last. */
  #without(child: X3DNode): void {
    const at = this.#others.lastIndexOf(child);
    if (at >= 0) this.#others.splice(at, 1);
  }

  add(child: X3DNode): void {
    this.#batched.add(child);
    this.#without(child);
  }

  /** Drawn by itself again, where it is still there. */
  delete(child: X3DNode): void {
    this.#batched.delete(child);
    if (child._parentNodes.includes(this.node)) this.#others.push(child);
  }

  #showOthers<T>(look: () => T): T {
    const { node } = this;
    const all = node._childNodes;
    if (this.#children !== all.length) this.#find(all);
    node._childNodes = this.#others;
    try {
      return look();
    } finally {
      node._childNodes = all;
    }
  }

  /** Somebody went past the group's own methods. */
  #find(all: X3DNode[]): void {
    this.#others = all.filter((child) => !this.#batched.has(child));
    this.#children = all.length;
  }
}
