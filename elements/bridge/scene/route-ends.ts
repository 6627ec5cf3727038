import { ownBinding, type Binding } from '../nodes/binding.js';
import { fieldNamed } from '../words/fields.js';
import type { PhysicsX3DNode, X3DNode, X3DOM } from '../x3dom/x3dom.js';

// x3dom takes any ROUTE: ours go to fields that there are, by X3D's name for them, and only where X3D allows it.

const isOurs = (node: X3DNode): node is PhysicsX3DNode => 'routedFields' in node;

/** Ours may stand for an element, or be made without one. */
const bindingOf = (node: X3DNode): Binding | undefined =>
  isOurs(node) && node.element ? ownBinding(node.element) : undefined;

function nameOf(node: X3DNode, field: string): string {
  const type = bindingOf(node)?.type;
  return (type && fieldNamed(type, field)) || field;
}

/** What speaks against a ROUTE at one end. */
function refusal(node: X3DNode, name: string, forbidden: string[], verb: string) {
  const binding = bindingOf(node);
  if (!binding) return undefined;
  const field = binding.type.fields[name];
  // x3dom's own fields of what it draws.
  if (!field && name in node._vf) return undefined;
  if (field && !forbidden.includes(field.access)) return undefined;
  return { binding, name, verb };
}

const refusals = (from: X3DNode, field: string, to: X3DNode, toField: string) =>
  [
    refusal(from, field, ['initializeOnly', 'inputOnly'], 'from'),
    refusal(to, toField, ['initializeOnly', 'outputOnly'], 'to'),
  ].filter((each) => each !== undefined);

export function watchRoutes(x: X3DOM): void {
  const { prototype } = x.nodeTypes.X3DNode;
  const { setupRoute, removeRoute } = prototype;
  prototype.setupRoute = function (this: X3DNode, field, to, toField): void {
    const [from, into] = [nameOf(this, field), nameOf(to, toField)];
    const refused = refusals(this, from, to, into);
    for (const { binding, name, verb } of refused) binding.refuse(name, verb);
    if (refused.length > 0) return;
    if (isOurs(this) && isOurs(to)) this.feedsPhysics = true;
    setupRoute.call(this, from, to, into);
  };
  prototype.removeRoute = function (this: X3DNode, field, to, toField): void {
    const [from, into] = [nameOf(this, field), nameOf(to, toField)];
    for (const { binding, name } of refusals(this, from, to, into)) binding.permit(name);
    removeRoute.call(this, from, to, into);
  };
}
