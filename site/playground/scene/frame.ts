// The page that a scene stands in: a frame of its own, so that nothing of it outlives it and its names and styles meet
// nothing of the site's. It runs x3dom and the library and no other script, whatever its markup or a file that the
// markup brings in says.
import type { worldOf } from '../../../elements/index.js';

export type World = NonNullable<ReturnType<typeof worldOf>>;

export interface ScenePage extends Window {
  worldOf?: typeof worldOf;
}

const STYLE = `
html, body { height: 100%; margin: 0 }
body { display: flex; flex-direction: column; background: linear-gradient(#dbe6ef, #a9b8c6); color: #14202b;
  font: 14px/1.4 system-ui, sans-serif }
x3d { flex: 1; min-height: 60%; width: 100% !important; border: 0 }
body > :not(x3d, main), main > :not(x3d) { margin: 6px 12px }
main { flex: 1; min-height: 0; display: flex; flex-direction: column }`;

/** `site` is the whole address where it lies. */
function pageOf(site: string): string {
  const nonce = crypto.randomUUID();
  const allowed = `'nonce-${nonce}' 'wasm-unsafe-eval' ${site}x3d-physics/ ${site}x3dom/`;
  const policy = `script-src ${allowed}; object-src 'none'; frame-src 'none'; base-uri 'none'; form-action 'none'`;
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<base target="_blank">
<title>The scene</title>
<link rel="stylesheet" href="${site}x3dom/x3dom.css">
<style>${STYLE}</style>
<script src="${site}x3dom/x3dom.js"></script>
<script type="module" nonce="${nonce}">
  import { worldOf } from '${site}x3d-physics/x3d-physics.js';
  window.worldOf = worldOf;
</script>
<body></body>`;
}

/** Puts the page into `parent`; answers when its scripts have run. */
export async function openScenePage(parent: HTMLElement, site: string): Promise<ScenePage> {
  const frame = document.createElement('iframe');
  frame.title = 'The scene';
  frame.srcdoc = pageOf(site);
  const loaded = new Promise((resolve) => frame.addEventListener('load', resolve, { once: true }));
  parent.replaceChildren(frame);
  await loaded;
  const page = frame.contentWindow as ScenePage | null;
  if (!page?.worldOf) throw new Error(`The library did not load from ${site}x3d-physics/.`);
  if (!('x3dom' in page)) throw new Error(`x3dom did not load from ${site}x3dom/.`);
  return page;
}
