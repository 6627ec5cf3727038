import { ContactPoint, PLACE } from '../../engine/contact-point.js';
import { length, normalize, subtract } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import type { Contact, ContactGiver } from '../../dynamics/contact.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { solveAdded } from './added-contacts.js';
import type { Pair } from './contact-rows.js';
import { Effect, type Cause } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { contactSurface } from './effects.js';
import type { ContactSurface } from './contact-surface.js';
import { demandsOf, union } from './demand-count.js';
import { keyOf } from './touches.js';

/** Reports of one and the same point lie this near, metres. */
const SAME = 1e-6;

/** Bullet keeps a contact point while it moves no farther than this along the surface, metres. */
const BREAKING = 0.02;

/** Values written back less exactly than they were read are the same, metres. */
const UNCHANGED = 1e-6;

/** A contact of page code is the one that a sensor reported for these geometries no farther away than this, metres. */
const NEAR = 0.01;

/** A contact that a sensor reported, and what stands for it in the list, with its parameters; null: it is left out. */
interface Said {
  contact: Contact;
  listed: Contact | null;
  parameters: ContactParameters | null;
}

/**
 * Contacts that page code hands to set_contacts, for the next step only. What a sensor reported and the list leaves
 * out does not push; what stands in the list acts with its values; what page code made acts as a contact of its own.
 * What no sensor reported yet acts as always. With a collider the list only changes parameters.
 */
export class GivenContacts extends Effect {
  readonly #simulation: Simulation;
  readonly #surface: ContactSurface;
  /** As `world.effects` names who needs contacts to be written. */
  host: unknown;
  /** What sensors reported after the last step. */
  readonly #reported = new Set<Contact>();
  readonly #lists = new Map<ContactGiver, readonly Contact[]>();
  /** For the step that runs, by pair of bodies. */
  readonly #said = new Map<number, Said[]>();
  /** Points where a list moved them, by their pointers, and the places that Bullet had them at. */
  readonly #moved: number[] = [];
  readonly #places: number[] = [];
  #dt = 0;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#surface = effects.get(contactSurface);
  }

  /** Sensors tell what they hand out, so that a contact that does not come back is known to be left out. */
  report(contacts: readonly Contact[]): void {
    for (const contact of contacts) this.#reported.add(contact);
  }

  /** What was reported is of a step before. */
  forget(): void {
    this.#reported.clear();
  }

  /** The world begins anew: lists were meant for the step that would have come. */
  override reset(): void {
    this.forget();
    if (this.active) this.#letGo();
  }

  give(collection: ContactGiver, list: readonly Contact[]): void {
    this.#lists.set(collection, list);
    this.need(collection, 'set_contacts');
    for (const contact of list) if (contact.isChanged) contact.wakeBodies();
    const all = [...this.#lists.values()].flat();
    this.host = collection.host;
    this.#surface.demandGiven(this, union(all.map((each) => demandsOf(each.parameters))));
  }

  override release(node: Cause): void {
    super.release(node);
    this.#lists.delete(node as ContactGiver);
  }

  override beforeStep(dt: number): void {
    this.#dt = dt;
    const added: Contact[] = [];
    for (const [collection, list] of this.#lists) {
      const onlyChanges = collection.hasCollider;
      const said = new Map<Contact, Contact>();
      for (const listed of list) {
        const contact = this.#meant(listed);
        if (contact) said.set(contact, listed);
        else if (!onlyChanges && !listed.pair) added.push(listed);
      }
      for (const contact of this.#reported) {
        const listed = said.get(contact) ?? null;
        const parameters = listed && listed.parameters;
        if (parameters || !onlyChanges) this.#say({ contact, listed, parameters });
      }
    }
    if (added.length > 0) solveAdded(added, this.#simulation, dt);
  }

  /** The reported contact that a listed one is, or is a copy of. */
  #meant(listed: Contact): Contact | undefined {
    if (this.#reported.has(listed)) return listed;
    const { position, first, second } = listed.touching;
    for (const contact of this.#reported) {
      const found = contact.found!;
      const same = found.first === first && found.second === second;
      if (same && length(subtract(found.position, position)) < NEAR) return contact;
    }
    return undefined;
  }

  #say(said: Said): void {
    const { contact, parameters } = said;
    if (!parameters) contact.wakeBodies();
    const [a, b] = contact.pair!;
    const key = keyOf(a, b);
    const others = this.#said.get(key);
    if (others) others.push(said);
    else this.#said.set(key, [said]);
  }

  /** Before bodies are read: one that is taken out of the world takes its points with it. */
  override settle(): void {
    this.#restore();
  }

  override afterStep(): void {
    this.#letGo();
  }

  #letGo(): void {
    this.#said.clear();
    for (const collection of [...this.#lists.keys()]) this.release(collection);
    this.#surface.demandGiven(this, undefined);
  }

  #restore(): void {
    if (this.#moved.length === 0) return;
    const point = new ContactPoint(this.#simulation.engine.ammo);
    this.#moved.forEach((pointer, i) => point.at(pointer, 0, 0).loadPlace(this.#places, i * PLACE));
    this.#moved.length = this.#places.length = 0;
  }

  /** What the list says of a point: parameters, null to leave it out, undefined for nothing. */
  at(point: ContactPoint, pair: Pair): ContactParameters | null | undefined {
    const all = this.#said.get(keyOf(pair.a, pair.b));
    if (!all) return undefined;
    // Two bodies that may not touch anywhere do not meet at a new point either.
    if (all.every(isLeftOut)) return null;
    const { origin } = this.#simulation.poses;
    const said = nearest(
      all,
      point,
      origin,
      BREAKING + Math.abs(point.distance) + point.reach(this.#dt),
    );
    if (said?.listed && isMoved(said.listed, said.contact)) this.#move(point, pair, said.listed);
    return said && said.parameters;
  }

  /** Position, normal and depth as the page wrote them. */
  #move(point: ContactPoint, pair: Pair, contact: Contact): void {
    this.#moved.push(point.pointer);
    point.savePlace(this.#places);
    const { depth, ...touching } = contact.touching;
    const position = subtract(touching.position, this.#simulation.poses.origin);
    const normal = normalize(touching.normal);
    for (let i = 0; i < 3; i++) {
      const n = normal[i]! * pair.carried;
      point.setNormal(i, n);
      point.setPosition(i, position[i]!);
      point.setPositionOnA(i, position[i]! - n * depth);
    }
    point.solverDistance = -depth;
  }
}

/** Whether page code wrote another position, normal or depth. */
function isMoved(listed: Contact, contact: Contact): boolean {
  if (!listed.isChanged) return false;
  const now = listed.touching;
  const found = contact.found!;
  const off = Math.max(
    length(subtract(now.position, found.position)),
    length(subtract(now.normal, found.normal)),
    Math.abs(now.depth - found.depth),
  );
  return off > UNCHANGED;
}

const isLeftOut = ({ parameters }: Said): boolean => parameters === null;

/** The contact reported nearest to a point. One that two sensors reported counts as listed if one of them is. */
function nearest(
  all: readonly Said[],
  point: ContactPoint,
  origin: Vec3,
  within: number,
): Said | undefined {
  let best: Said | undefined;
  let least = within;
  for (const said of all) {
    const { position, depth } = said.contact.found!;
    // Pushing an overlap apart moves the point without speed.
    const distance = point.distanceTo(subtract(position, origin)) - Math.abs(depth);
    if (distance > least + SAME) continue;
    if (!best || distance < least - SAME || said.parameters) best = said;
    least = Math.min(least, distance);
  }
  return best;
}
