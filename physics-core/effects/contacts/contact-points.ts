import type { Ammo } from '../../engine/ammo.js';
import { MANIFOLD_POINT as POINT } from '../../engine/offsets.js';
import type { BodyNode } from '../../nodes/body.js';
import type { World } from '../../world/world.js';

/** What the pair filter has taken back lies at 1e30 m. */
const FILTERED = 9e29;

/** Whether the pair filter has taken a point back: its collidables do not collide. */
export const isFiltered = ({ HEAPF32 }: Ammo, pointer: number): boolean =>
  HEAPF32[(pointer + POINT.distance) >> 2]! >= FILTERED;

/** Every contact point that the pair filter left in, and what hit at the very end of the step, by its pointer. */
export function eachContactPoint(
  world: World,
  visit: (pointer: number, a: BodyNode, b: BodyNode) => void,
): void {
  const { ammo, pairTest } = world.engine;
  pairTest.each(world.bullet.bullet, (pointer, pointerA, pointerB) => {
    const a = world.bodyAt(pointerA);
    const b = world.bodyAt(pointerB);
    if (a && b && !isFiltered(ammo, pointer)) visit(pointer, a, b);
  });
  world.bullet.eachManifold((manifold, pointerA, pointerB) => {
    const count = manifold.getNumContacts();
    const a = count > 0 && world.bodyAt(pointerA);
    const b = a && world.bodyAt(pointerB);
    if (!a || !b) return;
    const first = ammo.getPointer(manifold.getContactPoint(0));
    for (let i = 0; i < count; i++) {
      const pointer = first + i * POINT.size;
      if (!isFiltered(ammo, pointer)) visit(pointer, a, b);
    }
  });
}
