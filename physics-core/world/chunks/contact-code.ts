// The chunk `contacts`.
import { provideContactEffects } from '../../effects/contact-code.js';
import { reportGiven, reportOneSided } from '../../effects/contacts/collection-reports.js';
import type { ContactCode } from '../../effects/effect/chunks.js';
import { keeping } from '../../engine/keeping.js';
import { KeptWorld } from '../../engine/kept-world.js';
import { SolveOrder } from '../../engine/solve-order.js';
import { provideCollisionNodes } from '../../nodes/collision/classes.js';
import { meeting } from '../pairs/alone.js';
import { HardContacts } from '../pairs/hard-contacts.js';
import { Obstacles } from '../pairs/obstacles.js';
import { reportOverlaps } from '../pairs/overlaps.js';
import { Pairs } from '../pairs/pairs.js';
import { touchedBy } from '../pairs/touched-by.js';

export function provide(): ContactCode {
  provideContactEffects();
  provideCollisionNodes();
  keeping.of = (bullet, broadphase) => new KeptWorld(bullet, broadphase);
  keeping.orderOf = (ammo, world, dispatcher) => new SolveOrder(ammo, world, dispatcher);
  meeting.of = (world, bodies) => {
    const pairs = new Pairs(world, bodies);
    return { pairs, obstacles: new Obstacles(world, pairs) };
  };
  return {
    hardContacts: (world) => new HardContacts(world),
    reportOverlaps,
    touchedBy,
    reportGiven,
    reportOneSided,
  };
}
