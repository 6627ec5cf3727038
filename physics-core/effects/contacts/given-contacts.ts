import type { ContactPoint } from '../../engine/contact-point.js';
import { MANIFOLD_POINT as POINT } from '../../engine/offsets.js';
import type { Vec3 } from '../../fields/types.js';
import { length, normalize, subtract } from '../../base/math.js';
import type { ContactNode } from '../../nodes/contact.js';
import { unknownTokens, type ContactParameters } from '../../dynamics/contact-parameters.js';
import type { CollectionNode } from '../../nodes/rigid-body-collection.js';
import type { World } from '../../world/world.js';
import { cut } from '../../base/show.js';
import { solveAdded } from './added-contacts.js';
import type { Pair } from './contact-rows.js';
import { Effect } from '../effect.js';
import { demandsOf, NO_DEMANDS, union } from './solver-demands.js';
import { keyOf } from './touches.js';

/** Reports of one and the same point lie this near, metres. */
const SAME = 1e-6;

/** What of a point a list may move. */
const MOVED = [POINT.positionB, POINT.positionA, POINT.normalB];

/** Bullet keeps a contact point while it moves no farther than this along the surface, metres. */
const BREAKING = 0.02;

/** Values written back less exactly than they were read are the same, metres. */
const UNCHANGED = 1e-6;

/** A contact of page code is the one that a sensor reported for these geometries no farther away than this, metres. */
const NEAR = 0.01;

/** A contact that a sensor reported, and what stands for it in the list, with its parameters; null: it is left out. */
interface Said {
  contact: ContactNode;
  listed: ContactNode | null;
  parameters: ContactParameters | null;
}

/**
 * Contacts that page code hands to set_contacts, for the next step only. What a sensor reported and the list leaves
 * out does not push; what stands in the list acts with its values; what page code made acts as a contact of its own.
 * What no sensor reported yet acts as always. With a collider the list only changes parameters.
 */
export class GivenContacts extends Effect {
  readonly name = 'given contacts';
  readonly #world: World;
  /** What sensors reported after the last step. */
  readonly #reported = new Set<ContactNode>();
  readonly #lists = new Map<CollectionNode, ContactNode[]>();
  /** For the step that runs, by pair of bodies. */
  readonly #said = new Map<number, Said[]>();
  /** Points as Bullet had them where a list moved them: the pointer, then both positions and the normal. */
  readonly #moved: number[] = [];
  #dt = 0;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** Sensors tell what they hand out, so that a contact that does not come back is known to be left out. */
  report(contacts: ContactNode[]): void {
    for (const contact of contacts) this.#reported.add(contact);
  }

  /** What was reported is of a step before. */
  forget(): void {
    this.#reported.clear();
  }

  /** The world begins anew: lists were meant for the step that would have come. */
  reset(): void {
    this.forget();
    if (this.active) this.#letGo();
  }

  give(collection: CollectionNode, list: ContactNode[]): void {
    this.#lists.set(collection, list);
    this.need(collection, 'set_contacts');
    reportTokens(collection, list);
    for (const contact of list) if (contact.isChanged) contact.wakeBodies();
    const all = [...this.#lists.values()].flat();
    this.#world.registry.surface.demandGiven(union(all.map((each) => demandsOf(each.parameters))));
  }

  override drop(collection: CollectionNode): void {
    super.drop(collection);
    this.#lists.delete(collection);
  }

  override beforeStep(dt: number): void {
    this.#dt = dt;
    const added: ContactNode[] = [];
    for (const [collection, list] of this.#lists) {
      const onlyChanges = collection.asked('collider') !== null;
      const said = new Map<ContactNode, ContactNode>();
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
    if (added.length > 0) solveAdded(added, this.#world, dt);
  }

  /** The reported contact that a listed one is, or is a copy of. */
  #meant(listed: ContactNode): ContactNode | undefined {
    if (this.#reported.has(listed)) return listed;
    const position = listed.asked<Vec3>('position');
    const [first, second] = [listed.asked('geometry1'), listed.asked('geometry2')];
    for (const contact of this.#reported) {
      const found = contact.found!;
      const same = found.geometry1 === first && found.geometry2 === second;
      if (same && length(subtract(found.position as Vec3, position)) < NEAR) return contact;
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
    for (const collection of [...this.#lists.keys()]) this.drop(collection);
    this.#world.registry.surface.demandGiven(NO_DEMANDS);
  }

  #restore(): void {
    const moved = this.#moved;
    const heap = this.#world.engine.ammo.HEAPF32;
    for (let at = 0; at < moved.length;) {
      const pointer = moved[at++]!;
      for (const offset of MOVED)
        for (let i = 0; i < 3; i++) heap[((pointer + offset) >> 2) + i] = moved[at++]!;
    }
    moved.length = 0;
  }

  /** What the list says of a point: parameters, null to leave it out, undefined for nothing. */
  at(point: ContactPoint, pair: Pair): ContactParameters | null | undefined {
    const all = this.#said.get(keyOf(pair.a, pair.b));
    if (!all) return undefined;
    // Two bodies that may not touch anywhere do not meet at a new point either.
    if (all.every(isLeftOut)) return null;
    const said = nearest(all, point, BREAKING + Math.abs(point.distance) + point.reach(this.#dt));
    if (said?.listed && isMoved(said.listed, said.contact)) this.#move(point, pair, said.listed);
    return said && said.parameters;
  }

  /** Position, normal and depth as the page wrote them. */
  #move(point: ContactPoint, pair: Pair, contact: ContactNode): void {
    this.#moved.push(point.pointer);
    for (const offset of MOVED) for (let i = 0; i < 3; i++) this.#moved.push(point.get(offset, i));
    const position = contact.asked<Vec3>('position');
    const normal = normalize(contact.asked<Vec3>('contactNormal'));
    const depth = contact.asked<number>('depth');
    for (let i = 0; i < 3; i++) {
      const n = normal[i]! * pair.carried;
      point.put(POINT.normalB, n, i);
      point.put(POINT.positionB, position[i]!, i);
      point.put(POINT.positionA, position[i]! - n * depth, i);
    }
    point.put(POINT.distance, -depth);
  }
}

/** Whether page code wrote another position, normal or depth. */
function isMoved(listed: ContactNode, contact: ContactNode): boolean {
  if (!listed.isChanged) return false;
  const off = (field: string): number =>
    length(subtract(listed.asked<Vec3>(field), contact.found![field] as Vec3));
  const deeper = Math.abs(listed.asked<number>('depth') - (contact.found!.depth as number));
  return Math.max(off('position'), off('contactNormal'), deeper) > UNCHANGED;
}

const isLeftOut = ({ parameters }: Said): boolean => parameters === null;

/** The contact reported nearest to a point. One that two sensors reported counts as listed if one of them is. */
function nearest(all: readonly Said[], point: ContactPoint, within: number): Said | undefined {
  let best: Said | undefined;
  let least = within;
  for (const said of all) {
    const { position, depth } = said.contact.found!;
    // Pushing an overlap apart moves the point without speed.
    const distance = point.distanceTo(position as Vec3) - Math.abs(depth as number);
    if (distance > least + SAME) continue;
    if (!best || distance < least - SAME || said.parameters) best = said;
    least = Math.min(least, distance);
  }
  return best;
}

/** At the collection: contacts last a step only. */
function reportTokens(collection: CollectionNode, list: readonly ContactNode[]): void {
  const unknown = [...new Set(list.flatMap(unknownTokens))];
  if (unknown.length === 0) return;
  collection.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'set_contacts',
    value: unknown.join(' '),
    used: 'the others',
    message: `${collection.label}: the appliedParameters of a contact in set_contacts have no ${cut(unknown.join(', '))}; the others are used`,
  });
}
