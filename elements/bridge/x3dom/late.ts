import { isPhysics } from '../words/dom.js';
import { documentOf, nodeOf, x3dom, type NameSpace, type X3DElement } from './x3dom.js';

// x3dom has already met what we come to late: cures for that (x3dom.md).

/**
 * x3dom may come after us: while the page is read, or with a script that is added at any time. It reads the page on window
 * load or, past that, some milliseconds later, and the `load` of its script is heard before. `meet` is asked until it is
 * there.
 */
export function whenThere(meet: () => boolean): void {
  if (meet()) return;
  const events: [EventTarget, string][] = [
    [document, 'DOMContentLoaded'],
    [document, 'load'],
    [window, 'load'],
  ];
  const again = (): void => {
    if (!meet()) return;
    for (const [target, type] of events) target.removeEventListener(type, again, true);
  };
  for (const [target, type] of events) target.addEventListener(type, again, true);
}

const TIDIES = 'DOMNodeInsertedEvent_perSubtree';

/**
 * Our tags meant nothing to x3dom when it read the page, and it dropped all below them: it is shown them again, and `others`.
 * What it tidies away before that are nodes in them that something else USEs: there is nothing to tidy.
 */
export function setUpDropped(x3d: Element, others?: Set<Element>): void {
  const { caps } = x3dom() ?? {};
  const doc = caps && documentOf(x3d);
  const scene = doc?._scene?._xmlNode;
  if (!doc || !scene) return;
  const spaces = new Set<NameSpace>();
  for (const root of roots(scene)) {
    for (const element of root.querySelectorAll('*')) {
      const parent = element.parentElement;
      const above = parent && nodeOf(parent);
      if (!above || nodeOf(element) || !(isPhysics(element) || others?.has(element))) continue;
      const { [TIDIES]: tidies } = caps;
      caps[TIDIES] = false;
      doc.onNodeAdded(element, parent);
      caps[TIDIES] = tidies;
      if (above._nameSpace) spaces.add(above._nameSpace);
    }
  }
  for (const space of spaces) space.routeLateRoutes();
}

/** The scene tag, and those of the Inlines in it. */
function* roots(scene: Element): Generator<Element> {
  yield scene;
  for (const inline of scene.querySelectorAll('inline, Inline')) {
    const inner = nodeOf(inline)?._childNodes[0]?._xmlNode;
    if (inner) yield* roots(inner);
  }
}

const LISTENING = ['addEventListener', 'removeEventListener', 'highlight'];
const PATCHED = ['setAttribute', 'getAttribute', 'hasAttribute', ...LISTENING];

/** What x3dom appended to the `<x3d>` when it read it. */
const APPENDED = ':scope > canvas, :scope > div[class*="x3dom"], :scope > .x3dom-vr';
/** The same in a copy, whose canvas nobody draws on. */
const COPIED = APPENDED.replace('canvas', 'canvas.x3dom-canvas');

/**
 * x3dom does not read an `<x3d>` a second time, and wraps its patched methods in themselves if it is made to: an
 * element that comes back must look untouched.
 */
export function makeUnread(x3d: Element): void {
  const element = x3d as X3DElement;
  delete element.hasRuntime;
  delete element.runtime;
  for (const each of [x3d, ...x3d.querySelectorAll('*')]) unpatch(each);
  for (const appended of x3d.querySelectorAll(APPENDED)) appended.remove();
}

export function unpatch(element: Element): void {
  remove(element, PATCHED);
  remove(element, ['_x3domNode']);
}

/** Its own, which hide what every element has. */
function remove(element: Element, names: string[]): void {
  const own = element as Element & Record<string, unknown>;
  for (const name of names)
    for (const each of [name, `__${name}`]) if (Object.hasOwn(own, each)) delete own[each];
}

/**
 * x3dom's `removeX3DOMBackendGraph` leaves null in place of these on everything below what it removed, and does not
 * put them back.
 */
export function cureListeners(element: Element): void {
  if (element.addEventListener === null) remove(element, LISTENING);
}

/** An `<x3d>` pasted or cloned brings the old one's canvas along, and an empty box that was for handles of bodies. */
export function removeCopies(x3d: Element): void {
  for (const copied of x3d.querySelectorAll(COPIED)) copied.remove();
  for (const box of x3d.querySelectorAll(':scope > .x3d-physics-handles'))
    if (!box.shadowRoot) box.remove();
}

export const wasRead = (x3d: Element): boolean => (x3d as X3DElement).hasRuntime !== undefined;

/** Read once, but x3dom let go of it when it left the page. */
export const wasLetGo = (x3d: Element): boolean => wasRead(x3d) && !documentOf(x3d);
