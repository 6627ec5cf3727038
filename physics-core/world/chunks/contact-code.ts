// The chunk `contacts`.
import { provideContactEffects } from '../../effects/contact-code.js';
import { reportGiven, reportOneSided } from '../../effects/contacts/collection-reports.js';
import type { ContactCode } from '../../effects/effect/chunks.js';
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
