import type { PhysicsNode } from '../../../physics-core/inside.js';
import type { Binding } from './binding.js';
import { collectionNode, nodesIn, type Plan } from './plan.js';
import { listsAll, membersOf, nodesOf } from '../document/structure.js';
import type { PageWorld } from './worlds.js';

/** The one CollisionCollection among the children. */
function colliderOf(binding: Binding, world: PageWorld): PhysicsNode | null {
  const colliders = nodesOf(binding, 'collider', 'CollisionCollection').slice(0, 1);
  return nodesIn(world, colliders, binding)[0] ?? null;
}

export function planCollection(binding: Binding, world: PageWorld): Plan {
  return { world, relations: { collider: colliderOf(binding, world) } };
}

export function planSensor(binding: Binding, world: PageWorld): Plan {
  return { world, relations: { collider: colliderOf(binding, world) } };
}

const listedBy = (binding: Binding, world: PageWorld): '*' | PhysicsNode[] =>
  listsAll(binding) ? '*' : nodesIn(world, membersOf(binding), binding);

export function planColliders(binding: Binding, world: PageWorld): Plan {
  const collidables = listedBy(binding, world);
  return { world, collection: collectionNode(binding), relations: { collidables } };
}

export function planSpace(binding: Binding, world: PageWorld): Plan {
  return { world, relations: { collidables: listedBy(binding, world) } };
}
