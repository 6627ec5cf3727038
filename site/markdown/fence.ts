// A fence of `html live` is shown twice: as a page that runs, and as its markup.
//   ```html live            ```html live 420            ```html live 420 "A door with a motor"
//   ```html live folded 420      long markup: shown by a press
import type { MarkdownRenderer } from 'vitepress';
import { playgroundAddress } from '../playground/address.js';
import { frame } from './frame.js';

const LIVE = /^html live(?: (folded))?(?: (\d+))?(?: "([^"]+)")?/;
/** Pixels, where the fence names none. */
const HEIGHT = '340';

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** And nothing beside it: no buttons, no words. */
const isScene = (markup: string): boolean => /^\s*<x3d\b[^]*<\/x3d>\s*$/.test(markup);

/** In a frame of its own: its scripts run as in a page, and its WebGL context goes with it. */
const running = (markup: string, base: string, height = HEIGHT, title = 'The example, running') =>
  `<iframe v-pre class="live${isScene(markup) ? '' : ' with-more'}" loading="lazy" height="${height}" title="${escaped(title)}" srcdoc="${escaped(frame(markup, base))}"></iframe>\n`;

const folded = (code: string): string =>
  `<details class="markup"><summary>Its markup</summary>${code}</details>\n`;

const toPlayground = (markup: string, base: string): string =>
  `<p class="to-playground"><a href="${playgroundAddress(markup, base)}">Open in the playground</a></p>\n`;

export function liveExamples(md: MarkdownRenderer, base: string): void {
  const fence = md.renderer.rules.fence!;
  md.renderer.rules.fence = (tokens, at, ...rest) => {
    const { info, content } = tokens[at]!;
    const code = fence(tokens, at, ...rest);
    const live = LIVE.exec(info);
    if (!live) return code;
    const [, isFolded, height, title] = live;
    return (
      running(content, base, height, title) +
      (isFolded ? folded(code) : code) +
      toPlayground(content, base)
    );
  };
}
