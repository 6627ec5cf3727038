// A chart is a link to its own picture: on a phone it is wider than the page, and scrolls there. Its room is kept before it
// comes, so that nothing below it moves.
import { readFileSync } from 'node:fs';
import type { MarkdownRenderer } from 'vitepress';

/** Pixels, as its head says. */
function sizeOf(svg: string): { width: string; height: string } {
  const head = svg.slice(0, svg.indexOf('>'));
  const pixels = (name: string): string => new RegExp(`\\s${name}="([\\d.]+)"`).exec(head)![1]!;
  return { width: pixels('width'), height: pixels('height') };
}

export function charts(md: MarkdownRenderer, base: string): void {
  const image = md.renderer.rules.image!;
  md.renderer.rules.image = (tokens, at, ...rest) => {
    const source = tokens[at]!.attrGet('src')!;
    const isChart = source.endsWith('.svg');
    if (isChart) {
      const size = sizeOf(readFileSync(`docs${source}`, 'utf8'));
      for (const [name, pixels] of Object.entries(size)) tokens[at]!.attrSet(name, pixels);
    }
    const shown = image(tokens, at, ...rest);
    if (!isChart) return shown;
    return `<a class="chart" href="${base}${source.slice(1)}" target="_self">${shown}</a>`;
  };
}
