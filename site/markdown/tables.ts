// What tables need beyond Markdown.
import type { MarkdownRenderer } from 'vitepress';

/** Letters from which on the first column of a table is prose, and wants room. */
const PROSE = 60;

/** A table's empty corner is a cell, and no heading that says nothing. */
export function emptyHeads(md: MarkdownRenderer): void {
  md.core.ruler.push('empty-heads', ({ tokens }) => {
    tokens.forEach((token, i) => {
      if (token.type !== 'th_open' || tokens[i + 1]!.content.trim() !== '') return;
      token.tag = 'td';
      tokens[i + 2]!.tag = 'td';
    });
  });
}

type Token = ReturnType<MarkdownRenderer['parse']>[number];

/** The longest text of the first cells of a table's rows. */
function longestFirst(tokens: Token[], table: number): number {
  const end = tokens.findIndex(({ type }, i) => i > table && type === 'table_close');
  const lengths = tokens
    .slice(table, end)
    .flatMap((token, i, all) => (token.type === 'tr_open' ? [all[i + 2]!.content.length] : []));
  return Math.max(0, ...lengths);
}

/**
 * A table that begins with sentences is told apart: they get a column that they can be read in. By key, as all tables of the
 * site, it can be scrolled.
 */
export function proseTables(md: MarkdownRenderer): void {
  md.renderer.rules.table_open = (tokens, at) => {
    const prose = longestFirst(tokens, at) > PROSE ? ' class="prose-first"' : '';
    return `<table${prose} tabindex="0">\n`;
  };
}
