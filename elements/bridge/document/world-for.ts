import type { Binding } from '../nodes/binding.js';
import type { PageWorld } from '../nodes/surroundings.js';
import { jointBody } from './joint-bodies.js';
import { collectionOf, listing, membersOf, nodesOf, ownerOf, placesOf } from './structure.js';

type Finder = (binding: Binding) => PageWorld | undefined;

/** Of types that come in a chunk, by their names. */
export const lateWorlds: Record<string, Finder> = {};

/** The world that a node lives in; undefined while it lives in none. */
export function worldFor(binding: Binding): PageWorld | undefined {
  const { worlds, unlisted } = binding.scene!;
  const late = lateWorlds[binding.type.name];
  if (late) return late(binding);
  if (binding.isCollidable || binding.is('CollisionSpace')) {
    const user = ownerOf(binding) ?? listing(binding);
    if (user) return user.scope ? worldFor(user) : undefined;
    const free = binding.isCollidable && placesOf(binding).length > 0;
    return free ? unlisted.worldOf(binding) : undefined;
  }
  if (placesOf(binding).length === 0) return undefined;
  if (binding.is('RigidBodyCollection')) return worlds.of(binding);
  const collection = collectionOf(binding);
  if (collection) return worlds.of(collection);
  if (binding.is('RigidBody')) return worlds.default;
  if (binding.is('CollisionCollection'))
    return worldOfMembers(binding) ?? worlds.onlyFor(binding) ?? worlds.default;
  if (binding.is('CollisionSensor')) return worldOfCollider(binding);
  if (binding.is('Contact')) return undefined;
  return worldOfBodies(binding);
}

/** A CollisionCollection outside any collection speaks for the world of what it lists. */
function worldOfMembers(binding: Binding, asked = new Set<Binding>()): PageWorld | undefined {
  if (asked.has(binding) || !binding.scope) return undefined;
  asked.add(binding);
  for (const member of membersOf(binding)) {
    const owner = member.isCollidable ? ownerOf(member) : undefined;
    const world = owner ? worldFor(owner) : worldOfMembers(member, asked);
    if (world) return world;
  }
  return undefined;
}

function worldOfCollider(sensor: Binding): PageWorld | undefined {
  const [collider] = nodesOf(sensor, 'collider', 'CollisionCollection');
  return collider?.scope ? worldFor(collider) : undefined;
}

/** One that names no body is told so by the world that it would live in. */
function worldOfBodies(joint: Binding): PageWorld | undefined {
  const named = (['body1', 'body2'] as const)
    .map((side) => jointBody(joint, side))
    .filter((body) => body !== undefined);
  for (const body of named) if (body !== 'missing' && body.scope) return worldFor(body);
  return named.length > 0 ? undefined : joint.scene!.worlds.default;
}
