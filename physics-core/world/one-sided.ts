import type { CollisionCollectionNode } from '../nodes/collision-collection.js';
import { flatten, type Member } from '../nodes/collision-space.js';
import type { World } from './world.js';

/** Fields that say what contacts are like. */
const PARAMETERS = [
  'appliedParameters',
  'bounce',
  'frictionCoefficients',
  'minBounceSpeed',
  'slipFactors',
  'softnessConstantForceMix',
  'softnessErrorCorrection',
  'surfaceSpeed',
];

/**
 * A collider that lists the collidables of one body only and says what contacts are like contradicts itself: no pair
 * could ever have them. Such files mean the contacts of that body with everything else.
 */
export function isOneSided(world: World, collection: CollisionCollectionNode): boolean {
  const { settings } = world;
  if (settings.asked('collisionRules') === 'strict' || !isCollider(world, collection)) return false;
  const list = collection.asked<'*' | Member[]>('collidables');
  if (list === '*' || !PARAMETERS.some((name) => collection.authored(name))) return false;
  const owners = new Set([...flatten(list)].map((collidable) => collidable.owner ?? collidable));
  return owners.size === 1;
}

function isCollider(world: World, collection: CollisionCollectionNode): boolean {
  for (const node of world.rigidBodyCollections)
    if (node.asked('collider') === collection) return true;
  return false;
}

export function reportOneSided(collection: CollisionCollectionNode, is: boolean): void {
  if (!is) {
    collection.world.settle(collection, 'collidables', 'one-sided-collider');
    return;
  }
  collection.report({
    code: 'one-sided-collider',
    severity: 'warning',
    attribute: 'collidables',
    used: 'every pair with one member inside',
    message: `${collection.label} lists the collidables of one body only and yet says what its contacts are like; every pair with one member inside collides by it`,
  });
}
