// Markup as a tree that knows where in the text each of its parts stands.

export interface Place {
  from: number;
  to: number;
}

export interface Attribute extends Place {
  /** As written; HTML does not tell cases apart. */
  name: string;
  value: string;
}

/** Its place is that of its opening tag. */
export interface ElementNode extends Place {
  /** As written. */
  tag: string;
  /** By their names in lower case. */
  attributes: Map<string, Attribute>;
  children: TreeNode[];
}

export interface TextNode {
  text: string;
}

export type TreeNode = ElementNode | TextNode;

export const isElement = (node: TreeNode): node is ElementNode => 'tag' in node;

/** All elements, in the order of the text. */
export function* elementsIn(nodes: readonly TreeNode[]): Generator<ElementNode> {
  for (const node of nodes) {
    if (!isElement(node)) continue;
    yield node;
    yield* elementsIn(node.children);
  }
}
