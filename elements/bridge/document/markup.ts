import type { Binding } from '../nodes/binding.js';
import type { Scope } from '../scopes/scope.js';
import { known } from '../words/attributes.js';
import { attribute, isCustom, isPhysics, lowerName } from '../words/dom.js';

/** What may not stand in what: these pairs come from a tag that the author thought closed, or are misplaced. */
const IMPOSSIBLE: Record<string, RegExp> = {
  RigidBody: /rigid-?body|joint|collision|^shape$|^transform$|^scene$/,
  CollidableShape: /rigid-?body|joint|collision|collidable/,
  CollidableOffset: /rigid-?body|joint|collision/,
  CollisionCollection: /rigid-?body|joint|collision-?(collection|sensor)/,
  RigidBodyCollection: /rigid-?body-?collection|collidable|^scene$/,
};
/** What x3dom draws, or sees by, and not in a collection. */
const DRAWN = /^(transform|group|shape|viewpoint|navigationinfo|background|.*light)$/;
const JOINT_CHILD = /joint|collision|rigid-?body-?collection|^shape$|^transform$/;

/** Looks at the markup of one element, as the author wrote it. */
export function checkMarkup(binding: Binding): void {
  const { element, type } = binding;
  for (const { name } of element.attributes)
    if (!known(type, name)) binding.fault((faults) => faults.unknownAttribute(binding, name));
  for (const [name, verb] of binding.refused)
    binding.fault((faults) => faults.refusedRoute(binding, name, verb));
  const impossible =
    IMPOSSIBLE[type.name] ?? (type.name.endsWith('Joint') ? JOINT_CHILD : undefined);
  const child =
    impossible && [...element.children].find((each) => impossible.test(lowerName(each)));
  if (child) binding.fault((faults) => faults.misplacedChild(binding, child));
  if (type.name === 'RigidBodyCollection') checkDrawn(binding);
  const [disguised, meant] = otherTag(binding);
  if (meant) binding.fault((faults) => faults.otherTag(binding, disguised!, meant));
  if (isFirstForeign(binding)) binding.fault((faults) => faults.notUpgraded());
  const def = attribute(element, 'DEF');
  if (def && binding.scope!.names.bearers(def).at(-1) !== element)
    binding.fault((faults) => faults.duplicate(binding, def));
}

function checkDrawn(binding: Binding): void {
  const child = [...binding.element.children].find((each) => DRAWN.test(lowerName(each)));
  if (child) binding.fault((faults) => faults.undrawn(binding, child));
}

/** A child that means a node of ours by USE, and is called otherwise; and what it means. */
function otherTag({ element, scope }: Binding): [Element, Element] | [] {
  for (const child of element.children) {
    const name = isPhysics(child) ? null : attribute(child, 'USE');
    const meant = name && scope!.find(name);
    if (meant && isPhysics(meant)) return [child, meant];
  }
  return [];
}

/** By scope: the one that says that hyphenated tags there are no custom elements. */
const foreign = new WeakMap<Scope, Binding>();

function isFirstForeign(binding: Binding): boolean {
  const { element } = binding;
  const scope = binding.scope!;
  if (!element.localName.startsWith('x3d-') || isCustom(element)) return false;
  const first = foreign.get(scope);
  if (first?.scope === scope) return first === binding;
  foreign.set(scope, binding);
  return true;
}
