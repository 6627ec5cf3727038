import { contactReader, contactSurface } from '../../effects/contacts/effects.js';
import { contacts } from '../../effects/effect/chunks.js';
import type { BodyNode } from '../../nodes/body/body.js';
import type { CollidableNode } from '../../nodes/collision/collidable.js';
import type { CollisionCollectionNode } from '../../nodes/collision/collision-collection-node.js';
import type { CollisionSpaceNode } from '../../nodes/collision/collision-space-node.js';
import { CollisionFilterGroups } from './collision-filter-groups.js';
import { isOneSided } from './one-sided.js';
import type { NodeWorld, PairRules } from '../../nodes/node/node-world.js';

/** Whether contacts act; `where given`: those that set_contacts hands on. */
type Acting = 'always' | 'where given' | 'never';

/** Who collides with whom, and which CollisionCollection gives a pair its parameters. */
export class Pairs implements PairRules {
  readonly #world: NodeWorld;
  readonly #bodies: Iterable<BodyNode>;
  readonly #collections: CollisionCollectionNode[] = [];
  readonly #oneSided = new Set<CollisionCollectionNode>();
  /** The collections that list a collidable, enabled or not. */
  readonly #listing = new Map<CollidableNode, CollisionCollectionNode[]>();
  /** Those that sensors watch where the strict rules leave contacts to page code. */
  #watched: ReadonlySet<CollisionCollectionNode> = new Set();
  readonly #spaces = new Set<CollisionSpaceNode>();
  readonly #groups: CollisionFilterGroups;

  constructor(world: NodeWorld, bodies: Iterable<BodyNode>) {
    this.#world = world;
    this.#bodies = bodies;
    this.#groups = new CollisionFilterGroups(world, this, bodies);
  }

  get collections(): readonly CollisionCollectionNode[] {
    return this.#collections;
  }

  addCollection(collection: CollisionCollectionNode): void {
    if (!this.#collections.includes(collection)) this.#collections.push(collection);
    this.refresh();
  }

  removeCollection(collection: CollisionCollectionNode): void {
    const at = this.#collections.indexOf(collection);
    if (at >= 0) this.#collections.splice(at, 1);
    this.refresh();
  }

  /** Something about membership changed: every body goes to its groups again. */
  refresh(): void {
    if (!this.#world.started) return;
    this.#world.obstacles.due();
    this.#updateOneSided();
    this.#watched = this.#watchedNow();
    this.#listing.clear();
    this.#groups.refresh();
    for (const body of this.#bodies) this.#regroup(body);
  }

  addSpace(space: CollisionSpaceNode): void {
    this.#spaces.add(space);
  }

  removeSpace(space: CollisionSpaceNode): void {
    this.#spaces.delete(space);
  }

  /** Collections look up their members anew, and spaces whose triangles they want. */
  spacesChanged(): void {
    for (const collection of this.#collections) collection.updateMembers();
    for (const space of this.#spaces) space.updateGeometry();
  }

  /** Without collections, and with none gone just now, nothing but the default is said of contacts. */
  contactsChanged(body: BodyNode): void {
    const { registry } = this.#world;
    const surface =
      this.#collections.length > 0 ? registry.get(contactSurface) : registry.find(contactSurface);
    if (body.built) surface?.update(body);
  }

  /** The body goes: it is of no group. */
  leave(body: BodyNode): void {
    this.#groups.leave(body);
  }

  /** A sensor looks at something else. */
  watchChanged(): void {
    const now = this.#watchedNow();
    if (now.size !== this.#watched.size || [...now].some((one) => !this.#watched.has(one)))
      this.refresh();
  }

  #watchedNow(): ReadonlySet<CollisionCollectionNode> {
    const { store, registry } = this.#world;
    const waiting = [...store.collections].some(
      (node) => isWaiting(node) && !node.asked('collider'),
    );
    const watched = (waiting && registry.find(contactReader)?.watched) || [];
    return new Set(watched as CollisionCollectionNode[]);
  }

  /** A collider that lists one body only is read by whether it has parameters. */
  parametersChanged(): void {
    if (this.#updateOneSided()) this.refresh();
  }

  refreshBody(body: BodyNode): void {
    this.#listing.clear();
    if (!body.built) return;
    if (this.#updateOneSided()) this.refresh();
    else this.#regroup(body);
  }

  #regroup(body: BodyNode): void {
    if (!body.built) return;
    body.presence.update();
    this.contactsChanged(body);
  }

  // ---- membership -------------------------------------------------------------------------------------------------

  /** The collections that list a collidable, itself or an offset around it, enabled or not. */
  listing(collidable: CollidableNode): readonly CollisionCollectionNode[] {
    let found = this.#listing.get(collidable);
    if (!found) {
      const around = collidable.withOffsets;
      found = this.#collections.filter((c) => around.some((member) => c.lists(member)));
      this.#listing.set(collidable, found);
    }
    return found;
  }

  /** The CollisionCollections that list one of the body's collidables. */
  collectionsOf(body: BodyNode): CollisionCollectionNode[] {
    if (this.#collections.length === 0) return [];
    const members = body.collidables.flatMap((collidable) => collidable.withChildren);
    return this.#collections.filter((collection) =>
      members.some((member) => this.listing(member).includes(collection)),
    );
  }

  /** Whether a collection speaks for a pair of collidables: it lists both, or one where it is one-sided. */
  speaksFor(collection: CollisionCollectionNode, a: CollidableNode, b: CollidableNode): boolean {
    const [first, second] = [a, b].map((one) => this.listing(one).includes(collection));
    return this.#oneSided.has(collection) ? first! || second! : first! && second!;
  }

  /** A CollisionSpace around it wants its own triangles where a hull would do otherwise. */
  wantsTriangles(collidable: CollidableNode): boolean {
    for (const space of this.#spaces)
      if (collidable.withOffsets.some((one) => space.exact.has(one))) return true;
    return false;
  }

  // ---- who collides -----------------------------------------------------------------------------------------------

  /** Whether Bullet looks for contacts of two collidables of two bodies, joints aside. */
  meet(sideA: BodyNode, a: CollidableNode, sideB: BodyNode, b: CollidableNode): boolean {
    const acting = this.#acting(sideA, a, sideB, b);
    return acting === 'always' || (acting === 'where given' && this.#isWatched(a, b));
  }

  /** Whether they collide without being asked to: not where contacts wait for set_contacts. */
  collide(sideA: BodyNode, a: CollidableNode, sideB: BodyNode, b: CollidableNode): boolean {
    return this.#acting(sideA, a, sideB, b) === 'always';
  }

  /** Whether contacts of a body may only act where set_contacts hands them on. */
  waits(body: BodyNode): boolean {
    return [...this.#watched].some(
      (collection) =>
        collection.asked<boolean>('enabled') && this.collectionsOf(body).includes(collection),
    );
  }

  #acting(sideA: BodyNode, a: CollidableNode, sideB: BodyNode, b: CollidableNode): Acting {
    if (!sideA.isDynamic && !sideB.isDynamic) return 'never';
    const both = [this.#allowed(sideA, a, b), this.#allowed(sideB, b, a)];
    if (both.includes('never') || this.#switchedOff(a, b)) return 'never';
    return both.includes('where given') ? 'where given' : 'always';
  }

  /** What the rules of a body's own collection say of its collidable and the other. */
  #allowed(side: BodyNode, own: CollidableNode, other: CollidableNode): Acting {
    // An obstacle belongs to no collection: what meets it decides.
    if (side.isObstacle) return 'always';
    const collider = side.settings.asked<CollisionCollectionNode | null>('collider');
    if (!collider || collider.removed) return isWaiting(side.settings) ? 'where given' : 'always';
    const enabled = collider.asked<boolean>('enabled') && this.speaksFor(collider, own, other);
    return enabled ? 'always' : 'never';
  }

  #isWatched(a: CollidableNode, b: CollidableNode): boolean {
    for (const collection of this.#watched)
      if (collection.asked<boolean>('enabled') && this.speaksFor(collection, a, b)) return true;
    return false;
  }

  /** All collections that speak for the pair are disabled. */
  #switchedOff(a: CollidableNode, b: CollidableNode): boolean {
    const speaking = this.#collections.filter((collection) => this.speaksFor(collection, a, b));
    return speaking.length > 0 && !speaking.some((c) => c.asked<boolean>('enabled'));
  }

  /** The collection that gives a pair of collidables its parameters: the first enabled one that speaks for it. */
  between(a: CollidableNode, b: CollidableNode): CollisionCollectionNode | undefined {
    return this.#collections.find(
      (collection) => collection.asked<boolean>('enabled') && this.speaksFor(collection, a, b),
    );
  }

  /** The same for two bodies: of the first of their collidables that have one. */
  of(a: BodyNode, b: BodyNode): CollisionCollectionNode | undefined {
    for (const { collidable: first } of a.parts)
      for (const { collidable: second } of b.parts) {
        const found = this.between(first, second);
        if (found) return found;
      }
    return undefined;
  }

  /** Bullet's collision group and mask of a body. */
  groupsOf(body: BodyNode): [group: number, mask: number] {
    this.#reportLeftOut(body);
    return this.#groups.groupsOf(body);
  }

  // ---- reports ----------------------------------------------------------------------------------------------------

  #reportLeftOut(body: BodyNode): void {
    const collider = body.settings.asked<CollisionCollectionNode | null>('collider');
    body.reportWhile(this.#isLeftOut(body, collider), {
      code: 'not-in-collider',
      severity: 'info',
      used: 'no collision',
      message: `${body.label} is in none of the collidables of ${collider?.label} and collides with nothing`,
    });
  }

  #isLeftOut(body: BodyNode, collider: CollisionCollectionNode | null): boolean {
    // Before the collider itself is built nobody can be in it yet.
    if (!collider?.built || body.collidables.length === 0 || body.isObstacle) return false;
    return !this.#oneSided.has(collider) && !this.collectionsOf(body).includes(collider);
  }

  /** True where a collider became one-sided or is so no longer. */
  #updateOneSided(): boolean {
    let changed = false;
    for (const collection of this.#collections) {
      const now = isOneSided(this.#world, collection);
      if (now === this.#oneSided.has(collection)) continue;
      changed = true;
      if (now) this.#oneSided.add(collection);
      else this.#oneSided.delete(collection);
      contacts.code.reportOneSided(collection, now);
    }
    return changed;
  }
}

const isWaiting = (settings: BodyNode['settings']): boolean =>
  settings.asked('collisionRules') === 'strict';
