import type { PhysicsNode, World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { nodesIn } from '../plans/plan.js';
import { fieldsIn, isApart } from './plan-part.js';

/** A node of a part that a system has for itself. */
interface Own {
  node: PhysicsNode;
  world: World;
  /** As last handed to the core. */
  fields: Record<string, unknown>;
  /** The plan that is to be written has it. */
  planned: boolean;
}

const ownOf = new WeakMap<Binding, Map<Binding, Own>>();

/** The nodes of a system's emitter or models: where one that others have, too, says another place here, one of its own. */
export function partsIn(world: World, parts: readonly Binding[], system: Binding): PhysicsNode[] {
  return parts.flatMap((part) => {
    system.use(part);
    return isApart(part, system) ? ownNode(world, part, system) : nodesIn(world, [part], system);
  });
}

function ownNode(world: World, part: Binding, system: Binding): PhysicsNode {
  const all = ownOf.get(system) ?? new Map<Binding, Own>();
  ownOf.set(system, all);
  const fields = { ...part.authoredFields(), ...fieldsIn(part, system) };
  const own = all.get(part);
  if (own?.world === world) {
    edit(own, fields);
    own.planned = true;
    return own.node;
  }
  own?.node.remove();
  const options = { host: part.element, name: part.name, version: part.scope?.version };
  const node = world.add(part.type.name, fields, options);
  all.set(part, { node, world, fields, planned: true });
  return node;
}

function edit(own: Own, fields: Record<string, unknown>): void {
  for (const name of Object.keys({ ...own.fields, ...fields })) {
    if (JSON.stringify(own.fields[name]) === JSON.stringify(fields[name])) continue;
    if (name in fields) own.node.set(name, fields[name]);
    else own.node.unset(name);
  }
  own.fields = fields;
}

/** A system was written as planned, or its node went: those that it has no more go. */
export function dropParts(system: Binding): void {
  const all = ownOf.get(system);
  for (const [part, own] of all ?? []) {
    if (!own.planned) {
      own.node.remove();
      all!.delete(part);
    }
    // A system that goes into another world leaves its own first.
    if (system.node) own.planned = false;
  }
}
