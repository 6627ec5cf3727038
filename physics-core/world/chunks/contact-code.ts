// The chunk `contacts`.
import { provideContactEffects } from '../../effects/contact-code.js';
import { reportGiven, reportOneSided } from '../../effects/contacts/collection-reports.js';
import type { ContactCode } from '../../effects/effect/chunks.js';
import { provideCollisionNodes } from '../../nodes/collision/classes.js';
import { HardContacts } from '../pairs/hard-contacts.js';
import { reportOverlaps } from '../pairs/overlaps.js';
import { touchedBy } from '../pairs/touched-by.js';

export function provide(): ContactCode {
  provideContactEffects();
  provideCollisionNodes();
  return {
    hardContacts: (world) => new HardContacts(world),
    reportOverlaps,
    touchedBy,
    reportGiven,
    reportOneSided,
  };
}
