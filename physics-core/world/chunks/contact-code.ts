// The chunk `contacts`.
import { provideContactEffects } from '../../effects/contact-code.js';
import * as reports from '../../effects/contacts/collection-reports.js';
import * as parameters from '../../effects/contacts/parameters.js';
import type { ContactCode } from '../../effects/effect/chunks.js';
import { making } from '../../nodes/collision/collision-sensor.js';
import { foundContact } from '../../nodes/collision/found-contact.js';
import { HardContacts } from '../pairs/hard-contacts.js';
import { reportOverlaps } from '../pairs/overlaps.js';
import { touchedBy } from '../pairs/touched-by.js';

export function provide(): ContactCode {
  provideContactEffects();
  making.contact = foundContact;
  return {
    hardContacts: (world) => new HardContacts(world),
    reportOverlaps,
    touchedBy,
    ...reports,
    ...parameters,
  };
}
