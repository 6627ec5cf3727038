// A tree as the scene's page has it, by numbers, and the edits that bring the page to the next tree.
import { changesBetween, type Change } from '../text/changes.js';
import { isElement, type ElementNode, type TreeNode } from '../text/tree.js';

/** A node as the page is to make it. */
export type Made =
  | { id: number; text: string }
  | { id: number; tag: string; attributes: [name: string, value: string][]; children: Made[] };

/** `null` is the page's body, as parent, or the end, as the sibling before which a node comes. */
export type Edit =
  | { do: 'set'; id: number; name: string; value: string | null }
  | { do: 'write'; id: number; text: string }
  | { do: 'remove'; id: number }
  | { do: 'replace'; id: number; made: Made }
  | { do: 'place'; id: number; parent: number | null; before: number | null; made?: Made };

export class LiveTree {
  private readonly isOwn: (tag: string) => boolean;
  private roots: readonly TreeNode[] = [];
  private ids = new Map<TreeNode, number>();
  private elements = new Map<number, ElementNode>();
  private last = 0;

  /** `isOwn`: is it a tag of the library? */
  constructor(isOwn: (tag: string) => boolean) {
    this.isOwn = isOwn;
  }

  /** Another page, with this tree. */
  begin(roots: readonly TreeNode[]): Made[] {
    this.ids = new Map();
    this.elements = new Map();
    this.roots = roots;
    return roots.map((node) => this.make(node));
  }

  bringTo(roots: readonly TreeNode[]): Edit[] {
    const { changes, kept } = changesBetween(this.roots, roots);
    const removed = this.ids;
    this.ids = new Map();
    this.elements = new Map();
    for (const [node, old] of kept) this.name(node, removed.get(old)!);
    this.roots = roots;
    return changes.map((change) => this.edit(change, removed));
  }

  /** What the text has of a number. */
  sourceOf(id: number | null): ElementNode | undefined {
    return id === null ? undefined : this.elements.get(id);
  }

  private name(node: TreeNode, id: number): number {
    this.ids.set(node, id);
    if (isElement(node)) this.elements.set(id, node);
    return id;
  }

  private edit(change: Change, removed: ReadonlyMap<TreeNode, number>): Edit {
    if (change.do === 'remove') return { do: 'remove', id: removed.get(change.node)! };
    if (change.do === 'write') {
      return { do: 'write', id: this.ids.get(change.node)!, text: change.text };
    }
    if (change.do === 'set') return this.set(change.element, change.name, change.value);
    return this.place(change);
  }

  /** x3dom does not see that a USE changes. */
  private set(element: ElementNode, name: string, value: string | null): Edit {
    const id = this.ids.get(element)!;
    if (name.toLowerCase() === 'use' && !this.isOwn(element.tag.toLowerCase()))
      return { do: 'replace', id, made: this.make(element) };
    return { do: 'set', id, name, value };
  }

  private place({ node, parent, before }: Change & { do: 'place' }): Edit {
    const at = {
      parent: parent && this.ids.get(parent)!,
      before: before && this.ids.get(before)!,
    };
    const id = this.ids.get(node);
    if (id !== undefined) return { do: 'place', id, ...at };
    const made = this.make(node);
    return { do: 'place', id: made.id, ...at, made };
  }

  private make(node: TreeNode): Made {
    const id = this.name(node, ++this.last);
    if (!isElement(node)) return { id, text: node.text };
    const { tag, children } = node;
    const attributes = [...node.attributes.values()].map(({ name, value }): [string, string] => [
      name,
      value,
    ]);
    return { id, tag, attributes, children: children.map((child) => this.make(child)) };
  }
}
