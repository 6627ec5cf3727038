// Text to a tree, by the parsers of the editor itself, which give every part its place. Text that is not well-formed
// gives no tree: a scene is not brought to what is half typed.
import type { SyntaxNode } from '@lezer/common';
import { parser as htmlParser } from '@lezer/html';
import { parser as xmlParser } from '@lezer/xml';
import { decoded } from './entities.js';
import type { Attribute, ElementNode, Place, TreeNode } from './tree.js';
import { firstFault } from './well-formed.js';

export interface Fault extends Place {
  message: string;
}

export type Parsed = { roots: TreeNode[]; fault?: undefined } | { roots?: undefined; fault: Fault };

/** Comments and scripts may have anything in them. */
const NO_MARKUP = /<!--[^]*?-->|<script\b[^]*?<\/script>/gi;

/** It begins as XML does, or has a tag in X3D's own case that closes itself. */
export const isXml = (text: string): boolean =>
  /^\s*(?:<\?xml|<!DOCTYPE X3D\b|<X3D\b)/.test(text) ||
  /<[A-Z]\w*(?:\s[^<>]*)?\/>/.test(text.replaceAll(NO_MARKUP, ''));

export function parse(text: string): Parsed {
  const xml = isXml(text);
  const { topNode } = (xml ? xmlParser : htmlParser).parse(text);
  const fault = firstFault(topNode, text, xml);
  return fault ? { fault } : { roots: childrenOf(topNode, text) };
}

/** Words stand in them, and spaces count between two elements. */
const OF_WORDS =
  /^(a|b|button|code|dd|dt|em|fieldset|figcaption|h[1-6]|i|label|legend|li|p|s|small|span|strong|td|th|u)$/i;

function childrenOf(parent: SyntaxNode, text: string, tag = ''): TreeNode[] {
  const nodes: TreeNode[] = [];
  let words = '';
  const endText = () => {
    if (words.trim()) nodes.push({ text: words });
    else if (words && nodes.length > 0 && OF_WORDS.test(tag)) nodes.push({ text: ' ' });
    words = '';
  };
  for (let child = parent.firstChild; child; child = child.nextSibling) {
    if (child.name === 'Element') {
      endText();
      nodes.push(elementOf(child, text));
    } else words += textOf(child, text);
  }
  endText();
  return nodes;
}

const CDATA = /^<!\[CDATA\[|\]\]>$/g;

function textOf({ name, from, to }: SyntaxNode, text: string): string {
  const source = text.slice(from, to);
  if (name === 'Cdata') return source.replaceAll(CDATA, '');
  if (/^(ScriptText|StyleText)$/.test(name)) return source;
  return /Text$|Reference$|^InvalidEntity$/.test(name) ? decoded(source) : '';
}

function elementOf(node: SyntaxNode, text: string): ElementNode {
  const open = node.firstChild!;
  const tag = open.getChild('TagName')!;
  const attributes = new Map<string, Attribute>();
  for (const child of open.getChildren('Attribute')) {
    const attribute = attributeOf(child, text);
    const key = attribute.name.toLowerCase();
    // Of two the first counts, as in every browser.
    if (!attributes.has(key)) attributes.set(key, attribute);
  }
  return {
    from: open.from,
    to: open.to,
    tag: text.slice(tag.from, tag.to),
    attributes,
    children: childrenOf(node, text, text.slice(tag.from, tag.to)),
  };
}

function attributeOf(node: SyntaxNode, text: string): Attribute {
  const name = node.getChild('AttributeName')!;
  const value = node.getChild('AttributeValue') ?? node.getChild('UnquotedAttributeValue');
  const written = value ? text.slice(value.from, value.to) : '';
  const unquoted = value?.name === 'AttributeValue' ? written.slice(1, -1) : written;
  const { from, to } = node;
  return { from, to, name: text.slice(name.from, name.to), value: decoded(unquoted) };
}
