import type { BodyNode } from '../nodes/body.js';
import type { CollidableNode } from '../nodes/collidable.js';
import type { CollisionCollectionNode } from '../nodes/collision-collection.js';
import type { World } from './world.js';

/** Friction of a pair that no CollisionCollection speaks for. */
export const DEFAULT_FRICTION = 0.5;

/** Bullet 2.82 keeps 16 signed bits per body; the first is for bodies that no collider restricts. */
const FREE = 1;
const FIRST_BIT = 1;
const LAST_BIT = 14;
const EVERYTHING = -1;

/**
 * Who collides with whom, and with which parameters. CollisionCollections become bits of Bullet's collision groups:
 * `collider` lets only its own members meet; a disabled collection keeps its members apart.
 */
export class Pairs {
  readonly #world: World;
  readonly #collections: CollisionCollectionNode[] = [];

  constructor(world: World) {
    this.#world = world;
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
    for (const body of this.#world.bodies) this.refreshBody(body);
  }

  refreshBody(body: BodyNode): void {
    if (!body.built) return;
    body.updateMembership();
    this.#world.contactParametersChanged(body);
  }

  /** The CollisionCollections that list one of the body's collidables. */
  collectionsOf(body: BodyNode): CollisionCollectionNode[] {
    if (this.#collections.length === 0) return [];
    const members = body.collidables.flatMap(withChildren);
    return this.#collections.filter((collection) =>
      members.some((member) => collection.lists(member)),
    );
  }

  #bit(collection: CollisionCollectionNode): number {
    const at = this.#collections.indexOf(collection);
    return 1 << Math.min(FIRST_BIT + at, LAST_BIT);
  }

  /** Bullet's collision group and mask of a body. */
  groupsOf(body: BodyNode): [group: number, mask: number] {
    const mine = this.collectionsOf(body);
    const enabled = mine.filter((collection) => collection.asked<boolean>('enabled'));
    const bits = enabled.reduce((all, collection) => all | this.#bit(collection), 0);
    const collider = body.settings.asked<CollisionCollectionNode | null>('collider');
    if (collider) {
      const inside = enabled.includes(collider);
      this.#reportLeftOut(body, collider, mine.includes(collider));
      return [bits, inside ? this.#bit(collider) : 0];
    }
    if (body.settings.asked('collisionRules') === 'strict') return [bits, 0];
    if (mine.length > 0 && enabled.length === 0) {
      const off = mine.reduce((all, collection) => all | this.#bit(collection), 0);
      return [off, EVERYTHING & ~off];
    }
    return [FREE | bits, EVERYTHING];
  }

  #reportLeftOut(body: BodyNode, collider: CollisionCollectionNode, listed: boolean): void {
    // Before the collider itself is built nobody can be in it yet.
    if (listed || !collider.built || body.collidables.length === 0) {
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

  /** The collection that gives a pair its parameters: the first enabled one that lists both. */
  of(a: BodyNode, b: BodyNode): CollisionCollectionNode | undefined {
    const others = this.collectionsOf(b);
    return this.collectionsOf(a).find(
      (collection) => collection.asked<boolean>('enabled') && others.includes(collection),
    );
  }
}

function withChildren(collidable: CollidableNode): CollidableNode[] {
  const child =
    'collidable' in collidable.type.fields
      ? collidable.asked<CollidableNode | null>('collidable')
      : null;
  return child ? [collidable, ...withChildren(child)] : [collidable];
}
