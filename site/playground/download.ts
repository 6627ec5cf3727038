// The scene as one page by itself: x3dom and the library stand in it, so it runs by double click and without a network.
import { print } from './text/print.js';
import type { TreeNode } from './text/tree.js';

/** What such a page has inside, from where the site lies. */
const PARTS = [
  'x3dom/x3dom.css',
  'x3dom/x3dom.js',
  'x3d-physics/x3d-physics.single.js',
  'frame.css',
];

/** Asked for once, when somebody saves for the first time. */
let parts: Promise<string[]> | undefined;

async function textAt(address: string): Promise<string> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} did not load (${answer.status}).`);
  return answer.text();
}

/** `<\/` is the same in a script's strings, and ends no element; nor may a comment of HTML begin. */
const inScript = (text: string): string =>
  text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

/** So that modules of the text find the package by its name. */
const NAME_LIBRARY = `
  const names = Object.keys(X3DPhysics).filter((name) => /^\\w+$/.test(name));
  const module = 'export const { ' + names + ' } = globalThis.X3DPhysics;';
  const map = Object.assign(document.createElement('script'), { type: 'importmap' });
  map.text = JSON.stringify({ imports: { 'x3d-physics': 'data:text/javascript,' + encodeURIComponent(module) } });
  document.head.append(map);
`;

export async function pageOf(roots: readonly TreeNode[], site: string): Promise<Blob> {
  parts ??= Promise.all(PARTS.map((part) => textAt(site + part)));
  // The next press tries again.
  parts.catch(() => (parts = undefined));
  const [x3domCss, x3dom, library, css] = (await parts) as [string, string, string, string];
  const markup = print(roots);
  const naming = markup.includes('x3d-physics') ? `<script>{${NAME_LIBRARY}}</script>\n` : '';
  const page = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>A scene with physics</title>
<!-- The scene stands at the end of this file, behind x3dom and x3d-physics. -->
<link rel="icon" href="data:,">
<style>
${x3domCss}
${css}
</style>
<script>${inScript(x3dom)}</script>
<script>${inScript(library)}</script>
${naming}
${markup}
</html>
`;
  return new Blob([page], { type: 'text/html' });
}

export function save(name: string, file: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  // The browser has taken it by then.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
