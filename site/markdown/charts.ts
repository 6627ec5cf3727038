// A chart is a link to its own picture: on a phone it is wider than the page, and scrolls there.
import type { MarkdownRenderer } from 'vitepress';

export function charts(md: MarkdownRenderer, base: string): void {
  const image = md.renderer.rules.image!;
  md.renderer.rules.image = (tokens, at, ...rest) => {
    const source = tokens[at]!.attrGet('src')!;
    const shown = image(tokens, at, ...rest);
    if (!source.endsWith('.svg')) return shown;
    return `<a class="chart" href="${base}${source.slice(1)}" target="_self">${shown}</a>`;
  };
}
