// Fetched where x3dom has an engine of its own.
import { isPhysics } from '../words/dom.js';
import { unpatch } from './late.js';
import type { OwnTypes } from './own-engine.js';
import { documentOf, nodeOf, type X3DNode, type X3DNodeClass } from './x3dom.js';

const isTheirs = (element: Element, types: OwnTypes): boolean =>
  isPhysics(element) && types.has(nodeOf(element)?.constructor);

/** What x3dom made by the engine's types, before we came, becomes ours: whether there was any. */
export function makeOurs(x3d: Element, types: OwnTypes): boolean {
  const doc = documentOf(x3d);
  const all = [...x3d.querySelectorAll('*')].filter((element) => isTheirs(element, types));
  if (!doc || all.length === 0) return false;
  for (const element of all) removeDefaults(element, nodeOf(element)!);
  for (const element of all) {
    if (!isTheirs(element, types)) continue;
    const parent = element.parentElement!;
    doc.onNodeRemoved(element, parent);
    for (const each of [element, ...element.querySelectorAll('*')]) unpatch(each);
    doc.onNodeAdded(element, parent);
  }
  return true;
}

/** x3dom wrote defaults into attributes that were not there; they are no author's. A node of an empty element shows which. */
function removeDefaults(element: Element, node: X3DNode): void {
  const empty = document.createElementNS(element.namespaceURI, element.localName);
  const { doc } = node._nameSpace!;
  const type = node.constructor as X3DNodeClass;
  new type({ doc, runtime: null, xmlNode: empty, nameSpace: node._nameSpace! });
  const { getAttribute, removeAttribute } = Element.prototype;
  for (const { name, value } of empty.attributes)
    if (getAttribute.call(element, name) === value) removeAttribute.call(element, name);
}
