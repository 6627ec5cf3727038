/// <reference types="vite/client" />
// The pages beside it as stories: what stands in their <main>, and the markup to read.
import { html, render } from 'lit';
import { copyable } from './copyable.js';

/** Pages name their files from where they are in the repository; a story is served from its root. */
const fromRoot = (source: string) => source.replaceAll('../../', './');

/** A script that came by parsing does not run; one that is made does. */
function runnable(script: HTMLScriptElement): HTMLScriptElement {
  const copy = document.createElement('script');
  copy.textContent = script.textContent;
  return copy;
}

function markup(source: string): HTMLElement {
  const [main] = /(?<=<\/p>\n)[^]*(?=\n {4}<\/main>)/.exec(source)!;
  const details = document.createElement('details');
  const text = main!.replace(/^ {6}/gm, '');
  render(
    html`<summary>The markup</summary>
      ${copyable(text)}`,
    details,
  );
  return details;
}

/** The page itself, its library replaced by the one that the stories load. */
export function page(source: string): HTMLElement {
  const parsed = new DOMParser().parseFromString(fromRoot(source), 'text/html');
  const main = document.importNode(parsed.querySelector('main')!, true);
  for (const script of main.querySelectorAll('script')) script.replaceWith(runnable(script));
  main.append(markup(source));
  return main;
}

/** An XHTML page can't stand in an HTML one: it is shown in a frame. */
export function framed(file: string): HTMLElement {
  const main = document.createElement('main');
  const address = `./stories/pages/${file}`;
  main.innerHTML = `<iframe src="${address}" title="${file}"></iframe><p><a href="${address}">${file}</a> by itself</p>`;
  return main;
}
