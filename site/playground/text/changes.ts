// What leads from one tree to the next: the least that has to be done to the page. What the library and x3dom write
// into the page is in neither tree, so no change of the text can undo it.
import { inOrder } from './in-order.js';
import { isElement, type ElementNode, type TreeNode } from './tree.js';

/** `null` is the page itself, as parent, or the end of its children, as the sibling before which a node comes. */
export type Change =
  | { do: 'set'; element: ElementNode; name: string; value: string | null }
  | { do: 'write'; node: TreeNode; text: string }
  | { do: 'remove'; node: TreeNode }
  | { do: 'place'; node: TreeNode; parent: ElementNode | null; before: TreeNode | null };

export interface Changes {
  /** To be done in this order. All nodes are those of the next tree, but for those that are removed. */
  changes: Change[];
  /** Nodes of the next tree, and what they were in the last. */
  kept: Map<TreeNode, TreeNode>;
}

export function changesBetween(last: readonly TreeNode[], next: readonly TreeNode[]): Changes {
  const changes: Change[] = [];
  const kept = new Map<TreeNode, TreeNode>();

  function children(parent: ElementNode | null, was: readonly TreeNode[], is: readonly TreeNode[]) {
    const pairs = pair(was, is);
    const stays = new Set(pairs.values());
    for (const node of was) if (!stays.has(node)) changes.push({ do: 'remove', node });
    const unmoved = unmovedOf(was, is, pairs);
    // From the end, so that the sibling before which one comes is there already.
    for (let i = is.length - 1; i >= 0; i--) {
      const node = is[i]!;
      if (!unmoved.has(node))
        changes.push({ do: 'place', node, parent, before: is[i + 1] ?? null });
    }
    for (const [node, old] of pairs) same(old, node);
  }

  function same(old: TreeNode, node: TreeNode): void {
    kept.set(node, old);
    if (isElement(node) && isElement(old)) {
      attributes(old, node);
      children(node, old.children, node.children);
    } else if (!isElement(node) && !isElement(old) && node.text !== old.text) {
      changes.push({ do: 'write', node, text: node.text });
    }
  }

  function attributes(old: ElementNode, element: ElementNode): void {
    for (const [key, { name }] of old.attributes) {
      if (!element.attributes.has(key)) changes.push({ do: 'set', element, name, value: null });
    }
    for (const [key, { name, value }] of element.attributes) {
      if (old.attributes.get(key)?.value !== value)
        changes.push({ do: 'set', element, name, value });
    }
  }

  children(null, last, next);
  return { changes, kept };
}

/** Nodes that keep their order are not touched; the fewest others are moved. */
function unmovedOf(
  was: readonly TreeNode[],
  is: readonly TreeNode[],
  pairs: ReadonlyMap<TreeNode, TreeNode>,
): Set<TreeNode> {
  const places = new Map(was.map((node, i) => [node, i]));
  const staying = is.filter((node) => pairs.has(node));
  const order = inOrder(staying.map((node) => places.get(pairs.get(node)!)!));
  return new Set(order.map((i) => staying[i]!));
}

type Sign = (node: TreeNode) => string | undefined;

const tagOf: Sign = (node) => (isElement(node) ? node.tag.toLowerCase() : '');

/** What an element is named by its author. */
const nameOf: Sign = (node) => {
  if (!isElement(node)) return undefined;
  const name = node.attributes.get('def') ?? node.attributes.get('id');
  return name && `${tagOf(node)} ${name.value}`;
};

/** Says all of a node. */
const textOf = (node: TreeNode): string =>
  isElement(node)
    ? JSON.stringify([
        tagOf(node),
        [...node.attributes].map(([key, { value }]) => [key, value]).sort(),
        node.children.map(textOf),
      ])
    : node.text;

/** Which node of `was` each of `is` continues: what is alike at both ends, then by name, by content, by tag. */
function pair(was: readonly TreeNode[], is: readonly TreeNode[]): Map<TreeNode, TreeNode> {
  const texts = new Map([...was, ...is].map((node) => [node, textOf(node)]));
  const alike = (a: TreeNode | undefined, b: TreeNode | undefined) =>
    !!a && !!b && texts.get(a) === texts.get(b);
  const pairs = new Map<TreeNode, TreeNode>();
  let start = 0;
  while (alike(was[start], is[start])) pairs.set(is[start]!, was[start++]!);
  let [wasEnd, isEnd] = [was.length, is.length];
  while (wasEnd > start && isEnd > start && alike(was[wasEnd - 1], is[isEnd - 1])) {
    pairs.set(is[--isEnd]!, was[--wasEnd]!);
  }
  const [old, fresh] = [was.slice(start, wasEnd), is.slice(start, isEnd)];
  const signs: Sign[] = [nameOf, (node) => texts.get(node), tagOf];
  for (const sign of signs) match(old, fresh, sign, pairs);
  return pairs;
}

/** Pairs those that are still without one and have the same sign, in order. */
function match(
  old: TreeNode[],
  fresh: TreeNode[],
  sign: Sign,
  pairs: Map<TreeNode, TreeNode>,
): void {
  const taken = new Set(pairs.values());
  const waiting = new Map<string | undefined, TreeNode[]>();
  for (const node of old) {
    if (!taken.has(node)) waiting.set(sign(node), [...(waiting.get(sign(node)) ?? []), node]);
  }
  for (const node of fresh) {
    const mark = sign(node);
    const found = !pairs.has(node) && mark !== undefined && waiting.get(mark)?.shift();
    if (found) pairs.set(node, found);
  }
}
