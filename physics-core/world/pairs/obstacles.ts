import { CollidableNode } from '../../nodes/collision/collidable.js';
import type { BodyNode } from '../../nodes/body/body.js';
import { discardObstacle, makeObstacle } from '../../nodes/body/obstacle.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import type { ObstacleRules } from './alone.js';

/** Which collections there are, and which list a collidable. */
interface Listing {
  readonly collections: readonly unknown[];
  listing(collidable: CollidableNode): readonly unknown[];
}

/** The obstacles of a world: collidables that no body owns, but that a CollisionCollection lists. */
export class Obstacles implements ObstacleRules {
  readonly #world: NodeWorld;
  readonly #pairs: Listing;
  readonly #byCollidable = new Map<CollidableNode, BodyNode>();
  #due = false;

  constructor(world: NodeWorld, pairs: Listing) {
    this.#world = world;
    this.#pairs = pairs;
  }

  due(): void {
    this.#due = true;
  }

  update(): boolean {
    if (!this.#due) return false;
    this.#due = false;
    const wanted = this.#wanted();
    for (const [collidable, obstacle] of this.#byCollidable)
      if (!wanted.has(collidable)) this.#remove(collidable, obstacle);
    for (const collidable of wanted) this.#make(collidable);
    return true;
  }

  #wanted(): Set<CollidableNode> {
    const { nodes } = this.#world;
    const pairs = this.#pairs;
    const wanted = new Set<CollidableNode>();
    if (pairs.collections.length === 0) return wanted;
    for (const node of nodes) {
      if (!(node instanceof CollidableNode) || !node.unclaimed) continue;
      const listed = node.withChildren.some((one) => pairs.listing(one).length > 0);
      if (listed) wanted.add(node);
    }
    return wanted;
  }

  #make(collidable: CollidableNode): void {
    if (this.#byCollidable.has(collidable)) return;
    const obstacle = makeObstacle(this.#world, collidable);
    collidable.obstacle = obstacle;
    this.#byCollidable.set(collidable, obstacle);
  }

  #remove(collidable: CollidableNode, obstacle: BodyNode): void {
    this.#byCollidable.delete(collidable);
    collidable.obstacle = undefined;
    discardObstacle(obstacle);
  }

  clear(): void {
    for (const [collidable, obstacle] of this.#byCollidable) this.#remove(collidable, obstacle);
    this.#due = true;
  }
}
