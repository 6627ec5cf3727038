import { namers, ownBinding, type Binding } from '../nodes/binding.js';
import { attribute, isType } from '../words/dom.js';
import { nodeElement, parentIn } from '../scopes/instances.js';
import type { Scope } from '../scopes/scope.js';
import { byPlace } from './order.js';
import * as standing from '../scopes/standing.js';

// Who belongs to whom, read off the document: pure questions, asked anew whenever something near changed.

/** Where a node takes part: its own element and those that stand for it by USE, in document order. */
export const placesOf = (binding: Binding): Element[] =>
  standing.placesOf(binding.element, binding.scope!);

function collectionAbove(element: Element, scope: Scope): Binding | undefined {
  const [namer] = namers.of(element, 'RigidBodyCollection');
  if (namer) return namer;
  for (let at = parentIn(element, scope); at; at = above(at, scope)) {
    if (isType(at, 'RigidBodyCollection')) return ownBinding(at);
  }
  return undefined;
}

/** What stands above may be in the file around an instance. */
const above = (element: Element, { all }: Scope): Element | null => {
  const scope = all.around(element);
  return scope ? parentIn(element, scope) : element.parentElement;
};

const scopeOf = (place: Element, { scope }: Binding): Scope => scope!.all.around(place) ?? scope!;

/** The collection that a body, joint or CollisionCollection belongs to: the first in document order owns it. */
export function collectionOf(binding: Binding): Binding | undefined {
  const collections = placesOf(binding)
    .map((place) => collectionAbove(place, scopeOf(place, binding)))
    .filter((found) => found !== undefined);
  const [first] = collections;
  const second = collections.find((other) => other !== first);
  if (second) {
    binding.fault((faults) => faults.owned(binding, first.label, second.label, 'bodies'));
  }
  return first;
}

/** The body or joint child that an element means: itself, or what it stands for by USE. */
export function meant(user: Binding, element: Element, role: string): Binding | undefined {
  const use = attribute(element, 'USE');
  if (!use) return ownBinding(element);
  // What a prototype's field names stands in the file around it.
  const scope = user.scope!.all.around(element) ?? user.scope!;
  const found = scope.find(use, user);
  if (!found) {
    user.waitFor(role, use);
    return undefined;
  }
  return ownBinding(nodeElement(found, scope.all));
}

/**
 * The body that a collidable makes a shape of, through any offsets; the first in document order owns it. Offsets may
 * stand in each other in a circle: none is asked twice.
 */
export function ownerOf(collidable: Binding, asked = new Set<Binding>()): Binding | undefined {
  if (asked.has(collidable) || !collidable.scope) return undefined;
  asked.add(collidable);
  for (const place of placesOf(collidable)) {
    for (const holder of holdersOf(place, collidable, 'RigidBody', 'CollidableOffset')) {
      const owner = holder.is('RigidBody') ? holder : ownerOf(holder, asked);
      if (owner) return owner;
    }
  }
  return undefined;
}

/** The nodes of these types in which an element stands as a child, or that name it. */
export function holdersOf(place: Element, binding: Binding, ...types: string[]): Binding[] {
  const parent = parentIn(place, scopeOf(place, binding));
  const holder = parent && isType(parent, ...types) ? ownBinding(parent) : undefined;
  return [...(holder ? [holder] : []), ...namers.of(place, ...types)];
}

/**
 * The CollisionCollection that lists a collidable or a CollisionSpace, through any spaces and offsets. Nodes may stand
 * in each other in a circle: none is asked twice.
 */
export function listing(binding: Binding, asked = new Set<Binding>()): Binding | undefined {
  if (asked.has(binding) || !binding.scope) return undefined;
  asked.add(binding);
  for (const place of placesOf(binding)) {
    const types = ['CollisionCollection', 'CollisionSpace', 'CollidableOffset'];
    for (const holder of holdersOf(place, binding, ...types)) {
      if (holder.is('CollisionCollection')) return holder;
      const found = listing(holder, asked);
      if (found) return found;
    }
  }
  return undefined;
}

/**
 * The nodes of these types that a field names; where it names none, those among the children. Without what the node stands
 * in itself.
 */
export const nodesOf = (binding: Binding, role: string, ...types: string[]): Binding[] =>
  named(binding, role, ...types).filter((found) => !closesCircle(binding, found));

function named(binding: Binding, role: string, ...types: string[]): Binding[] {
  const elements = binding.named(role) ?? [...binding.element.children];
  return elements
    .map((element) => nodeElement(element, binding.scope!.all))
    .filter((element) => isType(element, ...types))
    .map((element) => meant(binding, element, role))
    .filter((found) => found !== undefined);
}

/** Of nodes that stand in each other in a circle, the last in document order goes without. */
function closesCircle(binding: Binding, found: Binding): boolean {
  if (!binding.is(...NESTING)) return false;
  const way = wayTo(binding, found);
  return way !== undefined && !way.some((other) => byPlace(other, binding) > 0);
}

/** Tells of what an offset or a space goes without, as it stands in that itself. */
export function tellCircles(binding: Binding): void {
  const role = nestingRole(binding);
  for (const found of named(binding, role, ...NESTING)) {
    if (closesCircle(binding, found))
      binding.fault((faults) => faults.nested(binding, found, role));
  }
}

/** Nodes that may stand in nodes of their kind. */
const NESTING = ['CollidableOffset', 'CollisionSpace'];

const nestingRole = (binding: Binding): string =>
  binding.is('CollisionSpace') ? 'collidables' : 'collidable';

/** From a node through what is in it to one that stands there again. */
function wayTo(end: Binding, at: Binding, asked = new Set<Binding>()): Binding[] | undefined {
  if (at === end) return [at];
  if (asked.has(at) || !at.scope || !at.is(...NESTING)) return undefined;
  asked.add(at);
  for (const next of named(at, nestingRole(at), ...NESTING)) {
    const way = wayTo(end, next, asked);
    if (way) return [at, ...way];
  }
  return undefined;
}

export const collidablesIn = (binding: Binding, role: string): Binding[] =>
  nodesOf(binding, role, 'CollidableShape', 'CollidableOffset');

/** Whether a CollisionCollection or CollisionSpace lists every collidable of its world. */
export function listsAll(binding: Binding): boolean {
  const lists = binding.is('CollisionCollection', 'CollisionSpace');
  const authored = lists && binding.authored('collidables');
  return typeof authored === 'string' && authored.trim() === '*';
}

/** What a CollisionCollection or CollisionSpace lists itself. */
export const membersOf = (binding: Binding): Binding[] =>
  nodesOf(binding, 'collidables', 'CollidableShape', 'CollidableOffset', 'CollisionSpace');

/** In X3DOM's older dialect joints name their bodies by a collidable. */
export function bodyOf(binding: Binding | undefined): Binding | undefined {
  if (!binding) return undefined;
  if (binding.is('RigidBody')) return binding;
  return binding.isCollidable && binding.scope ? ownerOf(binding) : undefined;
}
