// The elements of the page that stand for a tree's, and what brings them to the next tree.
import { changesBetween, type Change } from '../text/changes.js';
import { isElement, type ElementNode, type TreeNode } from '../text/tree.js';

export class LiveTree {
  private readonly body: HTMLElement;
  private readonly isOwn: (element: Element) => boolean;
  private readonly defaultOf: (element: Element, attribute: string) => string | undefined;
  private roots: readonly TreeNode[] = [];
  private nodes = new Map<TreeNode, ChildNode>();

  /** `isOwn`: is it an element of the library? `defaultOf`: of x3dom's, what an attribute is that is not there. */
  constructor(
    body: HTMLElement,
    isOwn: (element: Element) => boolean,
    defaultOf: (element: Element, attribute: string) => string | undefined,
  ) {
    this.body = body;
    this.isOwn = isOwn;
    this.defaultOf = defaultOf;
  }

  bringTo(roots: readonly TreeNode[]): void {
    const { changes, kept } = changesBetween(this.roots, roots);
    const removed = this.nodes;
    this.nodes = new Map();
    for (const [node, old] of kept) this.nodes.set(node, removed.get(old)!);
    for (const change of changes) this.apply(change, removed);
    this.roots = roots;
  }

  clear(): void {
    this.bringTo([]);
    this.body.replaceChildren();
  }

  /** Of an element in the page, what says it in the text: itself or what it stands in. */
  sourceOf(element: Element | null): ElementNode | undefined {
    for (let at: Element | null = element; at; at = at.parentElement) {
      for (const [node, live] of this.nodes) if (live === at && isElement(node)) return node;
    }
    return undefined;
  }

  private apply(change: Change, removed: ReadonlyMap<TreeNode, ChildNode>): void {
    if (change.do === 'remove') removed.get(change.node)!.remove();
    else if (change.do === 'write') this.nodes.get(change.node)!.textContent = change.text;
    else if (change.do === 'set') this.set(change.element, change.name, change.value);
    else this.place(change);
  }

  private set(element: ElementNode, name: string, value: string | null): void {
    const live = this.nodes.get(element) as Element;
    // The library's own elements follow every edit; x3dom sees neither of these two.
    if (!this.isOwn(live)) {
      if (name.toLowerCase() === 'use') return live.replaceWith(this.make(element));
      value ??= this.defaultOf(live, name) ?? null;
    }
    if (value === null) live.removeAttribute(name);
    else live.setAttribute(name, value);
  }

  private place({ node, parent, before }: Change & { do: 'place' }): void {
    const container = parent ? this.nodes.get(parent)! : this.body;
    const next = before && this.nodes.get(before)!;
    container.insertBefore(this.nodes.get(node) ?? this.make(node), next);
  }

  /** The whole of it before it comes into the page. */
  private make(node: TreeNode): ChildNode {
    const { ownerDocument } = this.body;
    if (!isElement(node)) {
      const words = ownerDocument.createTextNode(node.text);
      this.nodes.set(node, words);
      return words;
    }
    const element = ownerDocument.createElement(node.tag);
    for (const { name, value } of node.attributes.values()) element.setAttribute(name, value);
    element.append(...node.children.map((child) => this.make(child)));
    this.nodes.set(node, element);
    return element;
  }
}
