import type { ContactGiver } from '../dynamics/contact.js';
import { givenContacts } from '../effects/contacts/effects.js';
import { debugging } from '../effects/debug/debugging.js';
import { contacts } from '../effects/effect/chunks.js';
import { BodyNode } from './body/body.js';
import { show, showUsed } from '../base/show.js';
import type { ContactNode } from './collision/contact-node.js';
import { PhysicsNode } from './node/node.js';

/** Fields of bodies that act by what their collection says. */
const OF_BODIES = ['useGlobalGravity', 'autoDisable', 'dragMode', 'draggableBody'];

/** Settings of a world and defaults of the bodies under it. The first collection of a world gives the settings. */
export class CollectionNode extends PhysicsNode implements ContactGiver {
  #taken: ContactNode[] | undefined;

  get hasCollider(): boolean {
    return this.asked('collider') !== null;
  }

  configureWorld(): void {
    this.world.configure();
  }

  /** In a shared world the first collection's world-wide fields hold; what this one says otherwise is reported. */
  compareWith(first: CollectionNode): void {
    for (const [name, field] of Object.entries(this.type.fields)) {
      if (!field.worldWide) continue;
      const [asked, used] = [this.asked(name), first.asked(name)];
      this.reportWhile(this !== first && this.authored(name) && asked !== used, {
        code: 'shared-world-conflict',
        severity: 'warning',
        attribute: name,
        value: asked,
        used,
        message: `${this.label}: ${name}="${show(asked)}" differs from the first collection of the shared world; ${showUsed(used)} is used`,
      });
    }
  }

  /** Bodies read gravity and rest from their own collection. */
  eachBody(field: string): void {
    for (const node of this.world.nodes)
      if (node instanceof BodyNode) {
        if (node.settings === this) node.touch(field);
      } else if ((node.collection ?? this.world.settings) === this) node.collectionChanged?.();
  }

  updateColliders(): void {
    this.world.pairs.refresh();
  }

  /** A list acts once, and not again when the collection is made anew. */
  takeContacts(): void {
    const list = this.asked<ContactNode[]>('set_contacts');
    if (!this.authored('set_contacts') || list === this.#taken) return;
    this.#taken = list;
    contacts.code.reportGiven(this, list);
    this.world.registry.get(givenContacts).give(this, list);
  }

  updateDebug(): void {
    this.#draw(this.asked('debug'));
  }

  #draw(on: boolean): void {
    const { registry: effects } = this.world;
    if (on) effects.get(debugging).need(this, 'debug');
    else effects.find(debugging)?.release(this);
  }

  protected override created(): void {
    this.world.configure();
  }

  protected override released(): void {
    this.#draw(false);
    this.world.configure();
    this.world.pairs.refresh();
    // Bodies of no collection follow the first one, which may be another now.
    for (const field of OF_BODIES) (this.world.settings as CollectionNode).eachBody(field);
  }
}
