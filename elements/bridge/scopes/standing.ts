import { isPhysics, isType, lowerName, precedes } from '../words/dom.js';
import type { Scope } from './scope.js';
import type { Scopes } from './scopes.js';

// A node is one, wherever its DEF and its USEs stand. Where it is only kept, it takes no part.

/** Authoring tools keep nodes in metadata; those take part only where they are USEd. */
const isStore = (element: Element): boolean => lowerName(element).startsWith('metadata');

/** The element around an element: in a scope's root, what stands for that scope outside. */
const around = (element: Element, scope: Scope): Element | null =>
  element === scope.root ? scope.host : element.parentElement;

/** Whether an element takes part where it stands: it is not merely kept there, nor all that it is in. */
export function takesPart(place: Element, all: Scopes, asked = new Set<Element>()): boolean {
  if (asked.has(place)) return false;
  asked.add(place);
  const above: Element[] = [];
  let scope = all.around(place);
  for (let at = scope && around(place, scope); at; at = scope ? around(at, scope) : null) {
    if (at === scope?.host) scope = scope.parent ?? undefined;
    if (isStore(at))
      return above.some((each) => usesOf(each, all).some((use) => takesPart(use, all, asked)));
    above.push(at);
  }
  return true;
}

const usesOf = (element: Element, all: Scopes): Element[] =>
  all.around(element)?.usesOf(element) ?? [];

/** Where a node takes part: its own element and those that stand for it by USE, in document order. */
export function placesOf(element: Element, scope: Scope): Element[] {
  const uses = scope.usesOf(element);
  const places = uses.length > 0 ? inDocumentOrder([element, ...uses], scope.all) : [element];
  return places.filter((place) => takesPart(place, scope.all));
}

/** What stands in a scope inside stands where that scope does. */
export function inDocumentOrder(places: Element[], all: Scopes): Element[] {
  return places.sort((a, b) => inOrder(a, all.around(a)!, b, all.around(b)!));
}

/** As `precedes`, of elements in any scopes of an `<x3d>`. */
export function inOrder(left: Element, inLeft: Scope, right: Element, inRight: Scope): number {
  if (inLeft === inRight) return precedes(left, right);
  return depth(inLeft) >= depth(inRight)
    ? inOrder(inLeft.host!, inLeft.parent!, right, inRight)
    : inOrder(left, inLeft, inRight.host!, inRight.parent!);
}

const depth = (scope: Scope): number => (scope.parent ? depth(scope.parent) + 1 : 0);

/** In what nothing is drawn, though it has what is drawn elsewhere by USE. */
const UNDRAWN = ['RigidBody', 'CollisionCollection', 'CollisionSpace'];

/** Where an element is drawn: where it stands itself, or where the first USE of it does. */
export function drawnPlace(element: Element, scope: Scope): { element: Element; scope: Scope } {
  const uses = scope.usesOf(element);
  if (uses.length === 0) return { element, scope };
  const places = placesOf(element, scope);
  const seen = places.filter((each) => !isUndrawn(each));
  const place = seen.find((each) => each === element) ?? seen[0] ?? places[0] ?? element;
  return { element: place, scope: scope.all.around(place) ?? scope };
}

const isUndrawn = ({ parentElement }: Element): boolean =>
  !!parentElement && isPhysics(parentElement) && isType(parentElement, ...UNDRAWN);
