import { isFiltered } from '../effects/contacts/contact-points.js';
import { ContactPoint } from '../engine/contact-point.js';
import type { BodyNode } from '../nodes/body.js';
import type { World } from './world.js';

/** Bodies that begin deeper in each other than this are worth a word, metres. */
const DEEP = 0.02;

/** How deep each pair of bodies overlaps that may touch, metres; negative is a gap. */
function eachDepth(world: World, visit: (depth: number, a: BodyNode, b: BodyNode) => void): void {
  const { ammo } = world.engine;
  const point = new ContactPoint(ammo);
  world.bullet.eachManifold((manifold, a, b) => {
    const [first, second] = [world.bodyAt(a), world.bodyAt(b)];
    if (!first || !second || !(first.movable || second.movable)) return;
    let depth = -Infinity;
    for (let i = 0; i < manifold.getNumContacts(); i++) {
      const pointer = ammo.getPointer(manifold.getContactPoint(i));
      if (isFiltered(ammo, pointer)) continue;
      // Not the distance that Bullet holds: contact parameters write into it.
      depth = Math.max(depth, -point.at(pointer, a, b).distance);
    }
    visit(depth, first, second);
  });
}

/** Metres; 0 where nothing overlaps. */
export function deepestOverlap(world: World): number {
  let deepest = 0;
  eachDepth(world, (depth) => (deepest = Math.max(deepest, depth)));
  return deepest;
}

/** Tells of bodies that the first step found inside each other: they are pushed apart, which is seldom meant. */
export function reportOverlaps(world: World): void {
  eachDepth(world, (depth, first, second) => {
    if (depth <= DEEP) return;
    world.report(
      {
        code: 'initial-overlap',
        severity: 'info',
        attribute: 'position',
        value: depth,
        used: 'pushed apart',
        message: `${first.label} and ${second.label} begin ${depth.toFixed(2)} m inside each other and are pushed apart`,
      },
      first.movable ? first : second,
    );
  });
}
