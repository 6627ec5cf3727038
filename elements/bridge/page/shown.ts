import type { PageWorld } from '../nodes/surroundings.js';
import { page } from './page.js';

/** The world of the element with this DEF or id; without a name that of the nearest `<x3d>` with physics. */
export function worldShown(element: Element, name: string): PageWorld | undefined {
  if (name) return page.worldOf(bearer(element, name));
  for (let at: Element | null = element.parentElement; at; at = at.parentElement) {
    const world = firstWorldIn(at);
    if (world) return world;
  }
  return firstWorldIn(document.documentElement);
}

function firstWorldIn(root: Element): PageWorld | undefined {
  for (const x3d of root.querySelectorAll('x3d, X3D')) {
    const world = page.worldOf(x3d);
    if (world) return world;
  }
  return undefined;
}

/** In its own tree, in the page, then by DEF in any scene. */
function bearer(element: Element, name: string): Element | undefined {
  const root = element.getRootNode();
  const own = root instanceof ShadowRoot ? root.getElementById(name) : null;
  return own ?? document.getElementById(name) ?? page.find(name);
}
