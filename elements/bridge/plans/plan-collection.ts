import type { PhysicsNode, World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { collectionNode, nodesIn, type Plan } from './plan.js';
import { listsAll, membersOf, nodesOf, tellCircles } from '../document/structure.js';

/** The one CollisionCollection among the children. */
function colliderOf(binding: Binding, world: World): PhysicsNode | null {
  const colliders = nodesOf(binding, 'collider', 'CollisionCollection').slice(0, 1);
  return nodesIn(world, colliders, binding)[0] ?? null;
}

export function planCollection(binding: Binding, world: World): Plan {
  return { world, relations: { collider: colliderOf(binding, world) } };
}

export function planSensor(binding: Binding, world: World): Plan {
  return { world, relations: { collider: colliderOf(binding, world) } };
}

/** Names are no elements: collidables that stand elsewhere are listed by USE. */
function refuseNames(binding: Binding): void {
  const text = binding.authored('collidables');
  if (typeof text !== 'string' || !text.trim()) return;
  binding.fault((faults) => faults.namedCollidables(binding, text));
}

function listedBy(binding: Binding, world: World): '*' | PhysicsNode[] {
  if (listsAll(binding)) return '*';
  refuseNames(binding);
  return nodesIn(world, membersOf(binding), binding);
}

export function planColliders(binding: Binding, world: World): Plan {
  const collidables = listedBy(binding, world);
  return { world, collection: collectionNode(binding), relations: { collidables } };
}

export function planSpace(binding: Binding, world: World): Plan {
  tellCircles(binding);
  return { world, relations: { collidables: listedBy(binding, world) } };
}
