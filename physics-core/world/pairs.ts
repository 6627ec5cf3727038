import type { BodyNode } from '../nodes/body.js';
import type { CollidableNode } from '../nodes/collidable.js';
import type { CollisionCollectionNode } from '../nodes/collision-collection.js';
import type { CollisionSpaceNode } from '../nodes/collision-space.js';
import { CollisionFilterGroups } from './collision-filter-groups.js';
import { isOneSided, reportOneSided } from './one-sided.js';
import type { World } from './world.js';

/** Friction of a pair that no CollisionCollection speaks for. */
export const DEFAULT_FRICTION = 0.5;

/** What of a body decides whom it collides with, beside its collidables. */
export type Side = Pick<BodyNode, 'moves' | 'isObstacle' | 'settings'>;

/** Whether contacts act; `where given`: those that set_contacts hands on. */
type Acting = 'always' | 'where given' | 'never';

/** Who collides with whom, and which CollisionCollection gives a pair its parameters. */
export class Pairs {
  readonly #world: World;
  readonly #collections: CollisionCollectionNode[] = [];
  readonly #oneSided = new Set<CollisionCollectionNode>();
  /** The collections that list a collidable, enabled or not. */
  readonly #listing = new Map<CollidableNode, CollisionCollectionNode[]>();
  /** Those that sensors watch where the strict rules leave contacts to page code. */
  #watched: ReadonlySet<CollisionCollectionNode> = new Set();
  readonly spaces = new Set<CollisionSpaceNode>();
  readonly kinds: CollisionFilterGroups;

  constructor(world: World) {
    this.#world = world;
    this.kinds = new CollisionFilterGroups(world, this);
  }

  get collections(): readonly CollisionCollectionNode[] {
    return this.#collections;
  }

  add(collection: CollisionCollectionNode): void {
    if (!this.#collections.includes(collection)) this.#collections.push(collection);
    this.refresh();
  }

  remove(collection: CollisionCollectionNode): void {
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
    this.kinds.refresh();
    for (const body of this.#world.bodies) this.#regroup(body);
  }

  /** A sensor looks at something else. */
  watchChanged(): void {
    const now = this.#watchedNow();
    if (now.size !== this.#watched.size || [...now].some((one) => !this.#watched.has(one)))
      this.refresh();
  }

  #watchedNow(): ReadonlySet<CollisionCollectionNode> {
    const { rigidBodyCollections, registry } = this.#world;
    const waiting = [...rigidBodyCollections].some(
      (node) => isWaiting(node) && !node.asked('collider'),
    );
    return new Set(waiting ? registry.contacts.watched : []);
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
    body.updateMembership();
    this.#world.contactParametersChanged(body);
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
    for (const space of this.spaces)
      if (collidable.withOffsets.some((one) => space.exact.has(one))) return true;
    return false;
  }

  // ---- who collides -----------------------------------------------------------------------------------------------

  /** Whether Bullet looks for contacts of two collidables of two bodies, joints aside. */
  meet(sideA: Side, a: CollidableNode, sideB: Side, b: CollidableNode): boolean {
    const acting = this.#acting(sideA, a, sideB, b);
    return acting === 'always' || (acting === 'where given' && this.#isWatched(a, b));
  }

  /** Whether they collide without being asked to: not where contacts wait for set_contacts. */
  collide(sideA: Side, a: CollidableNode, sideB: Side, b: CollidableNode): boolean {
    return this.#acting(sideA, a, sideB, b) === 'always';
  }

  /** Whether contacts of a body may only act where set_contacts hands them on. */
  waits(body: BodyNode): boolean {
    return [...this.#watched].some(
      (collection) =>
        collection.asked<boolean>('enabled') && this.collectionsOf(body).includes(collection),
    );
  }

  #acting(sideA: Side, a: CollidableNode, sideB: Side, b: CollidableNode): Acting {
    if (!sideA.moves && !sideB.moves) return 'never';
    const both = [this.#allowed(sideA, a, b), this.#allowed(sideB, b, a)];
    if (both.includes('never') || this.#switchedOff(a, b)) return 'never';
    return both.includes('where given') ? 'where given' : 'always';
  }

  /** What the rules of a body's own collection say of its collidable and the other. */
  #allowed(side: Side, own: CollidableNode, other: CollidableNode): Acting {
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
    return this.kinds.groupsOf(body);
  }

  // ---- reports ----------------------------------------------------------------------------------------------------

  #reportLeftOut(body: BodyNode): void {
    const collider = body.settings.asked<CollisionCollectionNode | null>('collider');
    // Before the collider itself is built nobody can be in it yet.
    const waits = !collider?.built || body.collidables.length === 0 || body.isObstacle;
    if (waits || this.#oneSided.has(collider) || this.collectionsOf(body).includes(collider)) {
      this.#world.settle(body, undefined, 'not-in-collider');
      return;
    }
    body.report({
      code: 'not-in-collider',
      severity: 'info',
      used: 'no collision',
      message: `${body.label} is in none of the collidables of ${collider.label} and collides with nothing`,
    });
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
      reportOneSided(collection, now);
    }
    return changed;
  }
}

const isWaiting = (settings: Side['settings']): boolean =>
  settings.asked('collisionRules') === 'strict';
