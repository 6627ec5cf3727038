import type { MovingNode } from '../../nodes/body-motion.js';
import type { BodyNode } from '../../nodes/body.js';

/**
 * Wakes what touches a body that goes or jumps, or hangs on it: it may have lost its support. What is awake has nobody
 * asleep around it, and what sleeps fell asleep with all that touches it, so that an edit of either looks at no contact.
 */
export function wakeTouching(body: MovingNode): void {
  const { world, slot, movable, sleeping, joints } = body;
  if (movable && !sleeping) return;
  const island = movable ? world.registry.resting.islandOf(slot) : undefined;
  if (island) {
    for (const other of island) if (other !== body) other.wake();
    return;
  }
  for (const { attached, body1, body2 } of joints)
    if (attached) for (const end of [body1, body2]) end?.wake();
  wakeByContacts(body);
}

function wakeByContacts({ world, pointer }: MovingNode): void {
  world.bullet.eachManifold((manifold, a, b) => {
    if (manifold.getNumContacts() === 0 || (a !== pointer && b !== pointer)) return;
    world.bodyAt(a === pointer ? b : a)?.wake();
  });
}

/** Two bodies are joined: from now on they don't collide, and if they touch they let go of each other. */
export function partJoined(a: BodyNode, b: BodyNode): void {
  let touching = false;
  a.world.bullet.eachManifold((_, first, second) => {
    if (first === a.pointer ? second === b.pointer : first === b.pointer && second === a.pointer)
      touching = true;
  });
  if (touching) (a.movable ? a : b).partContacts();
}
