// A table's empty corner is a cell, and no heading that says nothing.
import type { MarkdownRenderer } from 'vitepress';

export function emptyHeads(md: MarkdownRenderer): void {
  md.core.ruler.push('empty-heads', ({ tokens }) => {
    tokens.forEach((token, i) => {
      if (token.type !== 'th_open' || tokens[i + 1]!.content.trim() !== '') return;
      token.tag = 'td';
      tokens[i + 2]!.tag = 'td';
    });
  });
}
