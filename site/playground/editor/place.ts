// Where in the markup a position of the text is: in a tag's name, at an attribute, in a value.
import { syntaxTree } from '@codemirror/language';
import type { EditorState } from '@codemirror/state';
import type { SyntaxNode } from '@lezer/common';

export interface MarkupPlace {
  at: 'tag' | 'attribute' | 'value';
  /** From where on the word under the position stands. */
  from: number;
  to: number;
  tag: string;
  /** Where it is an attribute or its value. */
  attribute: string;
  /** Those that the tag has. */
  others: string[];
}

const textOf = (state: EditorState, node: SyntaxNode | null | undefined): string =>
  node ? state.sliceDoc(node.from, node.to) : '';

const isTag = ({ name }: SyntaxNode): boolean => name === 'OpenTag' || name === 'SelfClosingTag';

function around(node: SyntaxNode | null, holds: (node: SyntaxNode) => boolean): SyntaxNode | null {
  let at = node;
  while (at && !holds(at)) at = at.parent;
  return at;
}

export function placeAt(
  state: EditorState,
  position: number,
  side: -1 | 0 | 1,
): MarkupPlace | null {
  const node = syntaxTree(state).resolveInner(position, side);
  if (node.name === 'StartTag') return at('tag', node.to, node.to, '', '', []);
  const open = around(node, isTag);
  if (!open) return null;
  const tag = textOf(state, open.getChild('TagName'));
  if (node.name === 'TagName') return at('tag', node.from, node.to, tag, '', []);
  const attributes = open.getChildren('Attribute');
  const names = attributes.map((each) => textOf(state, each.getChild('AttributeName')));
  const attribute = around(node, ({ name }) => name === 'Attribute');
  const own = textOf(state, attribute?.getChild('AttributeName'));
  const others = names.filter((name) => name !== own);
  if (node.name === 'AttributeValue') {
    // Without its quotes.
    return at('value', node.from + 1, Math.max(node.from + 1, node.to - 1), tag, own, others);
  }
  if (node.name === 'AttributeName') return at('attribute', node.from, node.to, tag, own, others);
  return at('attribute', position, position, tag, '', names);
}

const at = (
  kind: MarkupPlace['at'],
  from: number,
  to: number,
  tag: string,
  attribute: string,
  others: string[],
): MarkupPlace => ({ at: kind, from, to, tag, attribute, others });
