import type { CollisionCollectionNode } from '../../nodes/collision/collision-collection-node.js';
import { Members, type MemberList } from '../../nodes/collision/members.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';

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
export function isOneSided(world: NodeWorld, collection: CollisionCollectionNode): boolean {
  const { settings } = world;
  if (settings.asked('collisionRules') === 'strict' || !isCollider(world, collection)) return false;
  if (!PARAMETERS.some((name) => collection.authored(name))) return false;
  const { all, listed } = new Members(collection.asked<MemberList>('collidables'));
  const owners = new Set([...listed].map((collidable) => collidable.owner ?? collidable));
  return !all && owners.size === 1;
}

function isCollider(world: NodeWorld, collection: CollisionCollectionNode): boolean {
  for (const node of world.store.collections)
    if (node.asked('collider') === collection) return true;
  return false;
}
