// The first place at which text is not well-formed, and in what way.
import type { SyntaxNode } from '@lezer/common';
import type { Fault } from './parse.js';

/** Elements that have no content and no closing tag in HTML. */
export const VOID = /^(area|base|br|col|embed|hr|img|input|link|meta|param|source|track|wbr)$/i;

export function firstFault(top: SyntaxNode, text: string, xml: boolean): Fault | undefined {
  let found: Fault | undefined;
  top.cursor().iterate(({ node }) => {
    found ??= faultOf(node, text, xml);
    return !found;
  });
  return found;
}

function faultOf(node: SyntaxNode, text: string, xml: boolean): Fault | undefined {
  const { from, to, name } = node;
  const source = text.slice(from, to);
  if (!xml && name === 'OpenTag' && source.endsWith('/>') && !VOID.test(tagOf(node, text))) {
    const tag = tagOf(node, text);
    return { from, to, message: `In HTML a tag can't close itself: write <${tag}></${tag}>.` };
  }
  if (name === 'MismatchedCloseTag' || name === 'NoMatchCloseTag') {
    return { from, to, message: `${source} closes nothing that is open here.` };
  }
  if (name === 'IncompleteTag' || name === 'IncompleteCloseTag') {
    return { from, to, message: 'Here a tag begins that has no name yet.' };
  }
  if (node.type.isError || name === 'MissingCloseTag') return brokenIn(node.parent ?? node, text);
  return undefined;
}

const tagOf = (tag: SyntaxNode, text: string): string => {
  const name = tag.getChild('TagName');
  return name ? text.slice(name.from, name.to) : '';
};

/** What an error stands in says what is missing. */
function brokenIn({ name, from, to, firstChild }: SyntaxNode, text: string): Fault {
  const open = firstChild;
  if (name === 'Element' && open) {
    return { from: open.from, to: open.to, message: `<${tagOf(open, text)}> is not closed.` };
  }
  const line = text.indexOf('\n', from);
  const end = Math.max(from, Math.min(to, line < 0 ? text.length : line));
  if (/^Attribute/.test(name)) {
    return {
      from,
      to: end,
      message: 'This attribute is not finished: a value in quotes is missing.',
    };
  }
  if (/Tag$/.test(name)) return { from, to: end, message: 'This tag is not finished.' };
  return { from, to: end, message: 'This is no markup.' };
}
