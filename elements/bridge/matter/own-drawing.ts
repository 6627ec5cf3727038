import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { nodeOf, type X3DNode } from '../x3dom/x3dom.js';
import { drawingsIn } from './drawings.js';
import type { OwnShape } from './own-shape.js';

/** One node as x3dom draws it: a Shape of ours in the place of the author's. */
export abstract class OwnDrawing<Shape extends OwnShape> {
  protected readonly binding: Binding;
  #shapes: readonly Element[] = [];
  #world: PageWorld | null = null;
  #shape: Shape | undefined;
  #kind = '';

  constructor(binding: Binding) {
    this.binding = binding;
  }

  /** In each frame. */
  abstract draw(): void;
  protected abstract make(instead: X3DNode, appearance: X3DNode, kind: string): Shape;

  /** Another kind needs another Shape. */
  protected kindFor(_appearance: X3DNode): string {
    return '';
  }

  /** Its node was made, patched, moved, or went; these Shapes are what is seen of it. */
  changed(shapes: readonly Element[]): void {
    const { node, world } = this.binding;
    this.#shapes = shapes;
    const at = node ? world : null;
    if (at !== this.#world) {
      if (this.#world) drawingsIn(this.#world).delete(this);
      if (at) drawingsIn(at).add(this);
      this.#world = at;
    }
    if (at) at.work();
    else this.remove();
  }

  protected remove(): void {
    const shape = this.#shape;
    this.#shape = undefined;
    shape?.remove();
  }

  /** Of the first of its Shapes that x3dom has whole. */
  protected shapeNow(): Shape | undefined {
    for (const element of this.#shapes) {
      const shape: X3DNode | undefined = nodeOf(element);
      const appearance = shape?._cf.appearance?.node;
      if (!shape || !appearance || !shape._nameSpace?.doc._scene) continue;
      const kind = this.kindFor(appearance);
      if (kind === this.#kind && this.#shape?.wears(shape, appearance)) return this.#shape;
      this.remove();
      this.#kind = kind;
      return (this.#shape = this.make(shape, appearance, kind));
    }
    return undefined;
  }
}
