import type { World } from './inside.js';

/** A page in a frame, with the built library in it. */
export type PageWindow = Window & { X3DPhysics?: { worldOf(element: Element): World | undefined } };

function frame(): HTMLIFrameElement {
  const element = document.createElement('iframe');
  element.width = '400';
  element.height = '300';
  return element;
}

async function load(element: HTMLIFrameElement): Promise<PageWindow> {
  const loaded = new Promise((resolve) => element.addEventListener('load', resolve));
  document.body.replaceChildren(element);
  await loaded;
  return element.contentWindow as PageWindow;
}

/** Opens a page, by default one of test/pages. */
export function open(path: string, folder = 'test/pages'): Promise<PageWindow> {
  return load(Object.assign(frame(), { src: `/${folder}/${path}` }));
}

/** Opens a page given as text. */
export function openText(html: string): Promise<PageWindow> {
  return load(Object.assign(frame(), { srcdoc: html }));
}

/** Opens a page at any address. */
export const openUrl = (src: string): Promise<PageWindow> => load(Object.assign(frame(), { src }));

/** By DEF, in the page itself. */
export const named = (page: Window, name: string): Element =>
  [...page.document.querySelectorAll('*')].find(
    (element) => Element.prototype.getAttribute.call(element, 'DEF') === name,
  )!;

/** The world of the first physics element, started. */
export function worldIn(page: PageWindow): Promise<World> {
  const element = page.document.querySelector('x3d-rigid-body, RigidBody')!;
  return page.X3DPhysics!.worldOf(element)!.ready;
}

/** Adds a script to a page and waits until it has run. */
export async function addScript(page: Window, src: string, type = ''): Promise<void> {
  const script = Object.assign(page.document.createElement('script'), { src, type });
  const loaded = new Promise((resolve) => script.addEventListener('load', resolve));
  page.document.head.append(script);
  await loaded;
}
