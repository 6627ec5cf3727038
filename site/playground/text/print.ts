// A tree as HTML: what the playground shows, and nothing that it leaves out.
import { encoded } from './entities.js';
import { isElement, type ElementNode, type TreeNode } from './tree.js';

const VOID = /^(br|hr|input)$/i;
/** What stands in them is no markup. */
const RAW = /^(script|style)$/i;

const startOf = ({ tag, attributes }: ElementNode): string =>
  [tag, ...[...attributes.values()].map(({ name, value }) => `${name}="${encoded(value)}"`)].join(
    ' ',
  );

export function print(nodes: readonly TreeNode[], indent = ''): string {
  return nodes
    .filter((node) => isElement(node) || node.text.trim())
    .map((node) => printNode(node, indent))
    .join('\n');
}

const rawOf = (node: TreeNode): string => (isElement(node) ? '' : node.text);

function printNode(node: TreeNode, indent: string): string {
  if (!isElement(node)) return indent + encoded(node.text.trim());
  const start = `${indent}<${startOf(node)}>`;
  if (VOID.test(node.tag)) return start;
  const end = `</${node.tag}>`;
  if (RAW.test(node.tag)) return start + node.children.map(rawOf).join('') + end;
  if (node.children.length === 0) return start + end;
  return `${start}\n${print(node.children, `${indent}  `)}\n${indent}${end}`;
}
