import type { Binding } from '../nodes/binding.js';
import { attribute, lowerName, precedes } from './dom.js';
import { ownBinding } from '../nodes/binding.js';
import { containerField, isType } from './markup.js';
import type { PageWorld } from '../nodes/worlds.js';

// Who belongs to whom, read off the document: pure questions, asked anew whenever something near changed.

/** Where a node stands: its own element and those that stand for it by USE, in document order. */
export function placesOf(binding: Binding): Element[] {
  const uses = binding.scope!.names.usesOf(binding.element);
  const places = uses.length > 0 ? [binding.element, ...uses].sort(precedes) : [binding.element];
  return places.filter((place) => !inMetadata(place));
}

/** Authoring tools keep copies of nodes in metadata; those take part only where they are USEd. */
function inMetadata(element: Element): boolean {
  for (let at = element.parentElement; at; at = at.parentElement) {
    if (lowerName(at).startsWith('metadata')) return true;
  }
  return false;
}

function collectionAbove(element: Element): Binding | undefined {
  for (let at = element.parentElement; at; at = at.parentElement) {
    if (isType(at, 'RigidBodyCollection')) return ownBinding(at);
  }
  return undefined;
}

/** The collection that a body, joint or CollisionCollection belongs to: the first in document order owns it. */
export function collectionOf(binding: Binding): Binding | undefined {
  const collections = placesOf(binding)
    .map(collectionAbove)
    .filter((found) => found !== undefined);
  const [first] = collections;
  const second = collections.find((other) => other !== first);
  if (second) {
    binding.problem({
      code: 'already-owned',
      severity: 'warning',
      attribute: 'bodies',
      value: second.label,
      used: first.label,
      message: `${binding.label} belongs to ${first.label}; ${second.label} goes without it`,
    });
  }
  return first;
}

/** The body or joint child that an element means: itself, or what it stands for by USE. */
export function meant(user: Binding, element: Element, role: string): Binding | undefined {
  const use = attribute(element, 'USE');
  if (!use) return ownBinding(element);
  const found = user.scope!.find(use, user);
  if (!found) {
    user.waitFor(role, use);
    return undefined;
  }
  return ownBinding(found);
}

/** The body that a collidable makes a shape of, through any offsets; the first in document order owns it. */
export function ownerOf(collidable: Binding): Binding | undefined {
  const uses = collidable.scope!.names.usesOf(collidable.element);
  for (const place of [collidable.element, ...uses].sort(precedes)) {
    const parent = place.parentElement;
    if (!parent) continue;
    if (isType(parent, 'RigidBody')) return ownBinding(parent);
    const offset = isType(parent, 'CollidableOffset') ? ownBinding(parent) : undefined;
    const owner = offset && offset !== collidable ? ownerOf(offset) : undefined;
    if (owner) return owner;
  }
  return undefined;
}

/** The CollisionCollection that lists a collidable which no body owns. */
function listing(collidable: Binding): Binding | undefined {
  const parents = placesOf(collidable).map((place) => place.parentElement);
  const parent = parents.find((each) => each && isType(each, 'CollisionCollection'));
  return parent ? ownBinding(parent) : undefined;
}

export const isCollidable = (binding: Binding): boolean =>
  binding.is('CollidableShape', 'CollidableOffset');

/** The children that are collidables, by their own tag or by USE. */
export function collidablesIn(binding: Binding, role: string): Binding[] {
  const children = [...binding.element.children].filter((child) =>
    isType(child, 'CollidableShape', 'CollidableOffset'),
  );
  return children
    .map((child) => meant(binding, child, role))
    .filter((found) => found !== undefined);
}

export type Side = 'body1' | 'body2';

/** A joint's body: named by an attribute or property, else by a child. */
export function jointBody(joint: Binding, side: Side): Binding | 'missing' | undefined {
  const named = joint.authored(side);
  if (named instanceof Element) return bodyOf(ownBinding(named));
  if (typeof named === 'string' && named.trim()) return namedBody(joint, side, named.trim());
  const child = jointChild(joint.element, side);
  if (!child) return undefined;
  return bodyOf(meant(joint, child, side)) ?? 'missing';
}

function namedBody(joint: Binding, side: Side, name: string): Binding | 'missing' {
  const scope = joint.scope!;
  const element = scope.find(name, joint);
  const body = element && (bodyOf(ownBinding(element)) ?? scope.scene.bodyDriving(element));
  if (body) return body;
  joint.waitFor(side, name);
  return 'missing';
}

/** By containerField; children without one fill the sides that are left, in order. */
function jointChild(joint: Element, side: Side): Element | undefined {
  const children = [...joint.children].filter((child) =>
    isType(child, 'RigidBody', 'CollidableShape', 'CollidableOffset'),
  );
  const role = (child: Element): string | undefined => containerField(child)?.toLowerCase();
  const explicit = children.find((child) => role(child) === side);
  if (explicit) return explicit;
  const taken = new Set(children.map(role));
  const loose = children.filter((child) => role(child) !== 'body1' && role(child) !== 'body2');
  return loose[side === 'body1' || taken.has('body1') ? 0 : 1];
}

/** In X3DOM's older dialect joints name their bodies by a collidable. */
export function bodyOf(binding: Binding | undefined): Binding | undefined {
  if (!binding) return undefined;
  if (binding.is('RigidBody')) return binding;
  return isCollidable(binding) && binding.scope ? ownerOf(binding) : undefined;
}

/** The world that a node lives in; undefined while it lives in none. */
export function worldFor(binding: Binding): PageWorld | undefined {
  const { worlds } = binding.scope!.scene;
  if (binding.is('RigidBodyCollection')) return worlds.of(binding);
  if (isCollidable(binding)) {
    const user = ownerOf(binding) ?? listing(binding);
    return user?.scope ? worldFor(user) : undefined;
  }
  if (placesOf(binding).length === 0) return undefined;
  const collection = collectionOf(binding);
  if (collection) return worlds.of(collection);
  if (binding.is('RigidBody')) return worlds.default;
  if (binding.is('CollisionCollection'))
    return worldOfMembers(binding) ?? worlds.only ?? worlds.default;
  if (binding.is('CollisionSensor')) return worldOfCollider(binding);
  return worldOfBodies(binding);
}

/** A CollisionCollection outside any collection speaks for the world of what it lists. */
function worldOfMembers(binding: Binding): PageWorld | undefined {
  for (const member of collidablesIn(binding, 'collidables')) {
    const owner = ownerOf(member);
    if (owner) return worldFor(owner);
  }
  return undefined;
}

function worldOfCollider(sensor: Binding): PageWorld | undefined {
  const child = [...sensor.element.children].find((each) => isType(each, 'CollisionCollection'));
  const collider = child && meant(sensor, child, 'collider');
  return collider && worldFor(collider);
}

function worldOfBodies(joint: Binding): PageWorld | undefined {
  for (const side of ['body1', 'body2'] as const) {
    const body = jointBody(joint, side);
    if (body && body !== 'missing' && body.scope) return worldFor(body);
  }
  return undefined;
}
