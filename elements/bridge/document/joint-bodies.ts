import { ownBinding, type Binding } from '../nodes/binding.js';
import { nodeElement } from '../scopes/instances.js';
import { containerField, isType } from '../words/dom.js';
import { bodyOf, meant } from './structure.js';

/** Of a joint; or what else names a body. */
export type Side = 'body1' | 'body2' | 'body';

/** A joint's body: named by an attribute or property, else by a child. */
export function jointBody(joint: Binding, side: Side): Binding | 'missing' | undefined {
  const elements = joint.named(side);
  if (elements) return elements[0] && bodyOf(meant(joint, elements[0], side));
  const named = joint.authored(side);
  if (typeof named === 'string' && named.trim()) return namedBody(joint, side, named.trim());
  const child = jointChild(joint, side);
  if (!child) return undefined;
  return bodyOf(meant(joint, child, side)) ?? 'missing';
}

function namedBody(joint: Binding, side: Side, name: string): Binding | 'missing' {
  const scope = joint.scope!;
  const element = scope.find(name, joint);
  const body = element && (bodyOf(ownBinding(element)) ?? joint.scene!.drivers.of(element));
  if (body) return body;
  joint.waitFor(side, name);
  return 'missing';
}

/** By containerField; children without one fill the sides that are left, in order. */
function jointChild({ element, scope }: Binding, side: Side): Element | undefined {
  const node = (child: Element): Element => nodeElement(child, scope!.all);
  const children = [...element.children].filter((child) =>
    isType(node(child), 'RigidBody', 'CollidableShape', 'CollidableOffset'),
  );
  const role = (child: Element): string | undefined => containerField(child)?.toLowerCase();
  const explicit = children.find((child) => role(child) === side);
  if (explicit) return node(explicit);
  const taken = new Set(children.map(role));
  const loose = children.filter((child) => role(child) !== 'body1' && role(child) !== 'body2');
  const left = loose[side !== 'body2' || taken.has('body1') ? 0 : 1];
  return left && node(left);
}
