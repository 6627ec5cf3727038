import type { Collidable } from '../../dynamics/collidable.js';
import type { Sensor } from '../../dynamics/sensor.js';
import { contactReader, givenContacts } from '../../effects/contacts/effects.js';
import type { CollidableNode } from './collidable.js';
import type { CollisionCollectionNode } from './collision-collection-node.js';
import type { ContactNode } from './contact-node.js';
import { foundContact } from './found-contact.js';
import { PhysicsNode } from '../node/node.js';

/** Tells whether members of a CollisionCollection touch, and which. */
export class CollisionSensorNode extends PhysicsNode implements Sensor {
  isActive = false;
  readonly #touching = new Set<Collidable>();
  /** Of the last step, made when somebody asks. */
  #contacts: ContactNode[] | undefined;

  get collider(): CollisionCollectionNode | undefined {
    return this.asked<CollisionCollectionNode | null>('collider') ?? undefined;
  }

  get intersections(): CollidableNode[] {
    return [...this.#touching] as CollidableNode[];
  }

  get contacts(): ContactNode[] {
    if (!this.isActive) return [];
    return (this.#contacts ??= this.#readContacts());
  }

  /** The contacts of the last step that it watches, each a new node of its own. */
  #readContacts(): ContactNode[] {
    const contacts: ContactNode[] = [];
    const { registry: effects, events } = this.world;
    events.listened(this, 'contacts');
    effects.get(contactReader).eachWatched(this, (point, a, b, first, second) => {
      contacts.push(foundContact(this.world, point, a, b, first, second));
    });
    effects.get(givenContacts).report(contacts);
    return contacts;
  }

  /** Reads contacts only while it has something to watch. */
  updateWatch(): void {
    const { registry: effects } = this.world;
    if (this.collider && this.asked<boolean>('enabled')) {
      effects.get(contactReader).watch(this);
      return;
    }
    effects.find(contactReader)?.ignore(this);
    this.beginSensing();
    if (this.asked<boolean>('enabled')) this.finishSensing();
    else this.#silence();
  }

  /** Disabled it sends nothing, not even an end. */
  #silence(): void {
    this.isActive = false;
    this.#contacts = undefined;
  }

  /** What the same sensor has found in a world on another thread. */
  show(active: boolean | undefined, touching: Iterable<Collidable> | undefined): void {
    this.isActive = active ?? this.isActive;
    if (!touching) return;
    this.#touching.clear();
    for (const each of touching) this.#touching.add(each);
  }

  showContacts(contacts: ContactNode[]): void {
    this.#contacts = contacts;
  }

  // ---- after each step --------------------------------------------------------------------------------------------

  beginSensing(): void {
    this.#touching.clear();
  }

  noteTouch(a: Collidable, b: Collidable): void {
    this.#touching.add(a).add(b);
  }

  /** While something touches both lists are sent with every step; the end of contact sends them empty, once. */
  finishSensing(): void {
    const active = this.#touching.size > 0;
    const changed = active !== this.isActive;
    this.#contacts = undefined;
    this.isActive = active;
    if (active || changed) {
      if (this.heard('intersections')) this.emit('intersections', this.intersections);
      if (this.heard('contacts')) this.emit('contacts', this.contacts);
    }
    if (changed) this.emit('isActive', active);
  }

  /** Of a world that begins anew: what it said of the old one holds no longer. */
  protected override destroy(): void {
    this.world.registry.find(contactReader)?.ignore(this);
    this.beginSensing();
    this.finishSensing();
  }
}
