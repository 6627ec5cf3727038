import type { PhysicsNode } from '../../../physics-core/index.js';
import type { Binding } from './binding.js';
import { isType } from '../document/markup.js';
import { collectionNode, nodesIn, type Plan } from './plan.js';
import { collidablesIn, meant } from '../document/structure.js';
import type { PageWorld } from './worlds.js';

/** The one CollisionCollection among the children. */
function colliderOf(binding: Binding, world: PageWorld): PhysicsNode | null {
  const child = [...binding.element.children].find((each) => isType(each, 'CollisionCollection'));
  const collider = child && meant(binding, child, 'collider');
  return (collider && nodesIn(world, [collider], binding)[0]) ?? null;
}

export function planCollection(binding: Binding, world: PageWorld): Plan {
  return { world, relations: { collider: colliderOf(binding, world) } };
}

export function planSensor(binding: Binding, world: PageWorld): Plan {
  return { world, relations: { collider: colliderOf(binding, world) } };
}

export function planColliders(binding: Binding, world: PageWorld): Plan {
  const authored = binding.authored('collidables');
  const all = typeof authored === 'string' && authored.trim() === '*';
  const collidables = all ? '*' : nodesIn(world, members(binding), binding);
  return { world, collection: collectionNode(binding), relations: { collidables } };
}

/** Collidables listed directly or in CollisionSpaces, which only group them. */
function members(binding: Binding): Binding[] {
  const spaces = [...binding.element.children].filter((child) => isType(child, 'CollisionSpace'));
  const inSpaces = spaces.flatMap((child) => {
    const space = meant(binding, child, 'collidables');
    return space?.scope ? members(space) : [];
  });
  return [...collidablesIn(binding, 'collidables'), ...inSpaces];
}
