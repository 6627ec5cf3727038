import { isPhysics, isTemplate, lowerName } from '../words/dom.js';
import type { Scope } from './scope.js';
import type { Scopes } from './scopes.js';

// An instance of a prototype is the first node of the prototype's body: the others only help that one.

const NO_NODES = new Set(['is', 'route', 'import', 'export', 'protoinstance']);

function firstNode(body: Element): Element | undefined {
  return [...body.children].find((each) => !isTemplate(each) && !NO_NODES.has(lowerName(each)));
}

/** The node that an element is: its own, or for an instance the first of its prototype's body. */
export function nodeElement(element: Element, scopes: Scopes): Element {
  if (isPhysics(element)) return element;
  const scope = scopes.in(element);
  const first = scope?.isPrototype ? firstNode(scope.root) : undefined;
  return first ? nodeElement(first, scopes) : element;
}

/** The element in which one stands; for the node that is an instance, where the instance stands. */
export function parentIn(element: Element, scope: Scope): Element | null {
  const { root, host, parent, isPrototype } = scope;
  if (element.parentElement !== root || !isPrototype || !host || !parent)
    return element.parentElement;
  return firstNode(root) === element ? parentIn(host, parent) : root;
}
