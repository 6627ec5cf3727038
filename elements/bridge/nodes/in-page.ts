import { codecs, nodeTypes, PhysicsNode, type Units } from '../../../physics-core/inside.js';
import type { Field } from '../words/dom.js';
import { holdsNodes, inFileUnits, inSI } from '../words/fields.js';

// Nodes on their way between core and page: a page sees elements, and contacts, which have none, as plain objects.

/** The contact that a plain object shows; a copy that page code makes by spreading has it, too. */
const SHOWN = Symbol('contact');

type Data = Record<string, unknown> & { [SHOWN]?: PhysicsNode };

const contactFields = (): Record<string, Field> =>
  (nodeTypes.Contact?.fields ?? {}) as Record<string, Field>;

/** A node as its element, a contact as a plain object in file units; lists of them likewise. */
export function inPage(value: unknown, units: Units): unknown {
  if (Array.isArray(value)) return value.map((each) => inPage(each, units));
  if (!(value instanceof PhysicsNode)) return value;
  if (value.host instanceof Element) return value.host;
  return value.type.name === 'Contact' ? contactInPage(value, units) : value;
}

function contactInPage(contact: PhysicsNode, units: Units): Data {
  const data: Data = { [SHOWN]: contact };
  for (const [name, field] of Object.entries(contactFields())) {
    const value = contact.get(name);
    data[name] = holdsNodes(field) ? inPage(value, units) : inFileUnits(field, value, units);
  }
  return data;
}

/** What ties an element to its node. */
interface Tie {
  readonly node: PhysicsNode | null;
  is(type: string): boolean;
  authoredFields(): Record<string, unknown>;
  named(field: string): Element[] | undefined;
}
type TieOf = (element: Element) => Tie | undefined;

/** What script hands over as contacts: elements, or plain objects as it got them, changed or of its own making. */
export function inCore(value: unknown, units: Units, tieOf: TieOf): unknown {
  if (typeof value !== 'object' || value === null || value instanceof PhysicsNode) return value;
  if (value instanceof Element) return elementInCore(value, tieOf);
  if (Symbol.iterator in value)
    return Array.from(value as Iterable<unknown>, (each) => inCore(each, units, tieOf)).filter(
      Boolean,
    );
  return contactInCore(value as Data, units, tieOf);
}

/** An element that stands in no scene has no node: its fields are handed over. */
function elementInCore(element: Element, tieOf: TieOf): unknown {
  const tie = tieOf(element);
  if (!tie || tie.node || !tie.is('Contact')) return tie?.node ?? null;
  const data: Data = { type: 'Contact', ...tie.authoredFields() };
  for (const [name, field] of Object.entries(contactFields())) {
    const [named] = holdsNodes(field) ? (tie.named(name) ?? []) : [];
    if (named) data[name] = elementInCore(named, tieOf);
  }
  return data;
}

/** One that the core sent goes back as it is, with what page code changed. */
function contactInCore(contact: Data, units: Units, tieOf: TieOf): unknown {
  const shown = contact[SHOWN];
  const data: Data = { type: 'Contact' };
  for (const [name, field] of Object.entries(contactFields())) {
    const value = contact[name];
    if (value === undefined) continue;
    const given = holdsNodes(field) ? inCore(value, units, tieOf) : inSI(field, value, units);
    if (!shown) data[name] = given;
    else if (!codecs[field.type].equal(given, shown.get(name))) shown.set(name, given);
  }
  return shown ?? data;
}
