import { ContactPoint } from '../engine/contact-point.js';
import type { World } from './world.js';

/** Bodies that begin deeper in each other than this are worth a word, metres. */
const DEEP = 0.02;

/** Tells of bodies that the first step found inside each other: they are pushed apart, which is seldom meant. */
export function reportOverlaps(world: World): void {
  const { ammo } = world.engine;
  const point = new ContactPoint(ammo);
  world.bullet.eachManifold((manifold, a, b) => {
    let depth = 0;
    for (let i = 0; i < manifold.getNumContacts(); i++) {
      // Not the distance that Bullet holds: contact parameters write into it.
      depth = Math.max(
        depth,
        -point.at(ammo.getPointer(manifold.getContactPoint(i)), a, b).distance,
      );
    }
    const [first, second] = [world.bodyAt(a), world.bodyAt(b)];
    if (depth <= DEEP || !first || !second || !(first.movable || second.movable)) return;
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
