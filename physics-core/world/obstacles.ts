import { CollidableNode } from '../nodes/collidable.js';
import { makeObstacle, type ObstacleNode } from '../nodes/obstacle.js';
import type { World } from './world.js';

/** The obstacles of a world: collidables that no body owns, but that a CollisionCollection lists. */
export class Obstacles {
  readonly #world: World;
  readonly #byCollidable = new Map<CollidableNode, ObstacleNode>();
  #due = false;

  constructor(world: World) {
    this.#world = world;
  }

  /** Something came, went, or was listed: who is an obstacle is looked at after the present edits. */
  due(): void {
    this.#due = true;
  }

  /** True where obstacles were made, which are edits in their turn. */
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
    const { nodes, pairs } = this.#world;
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
    const obstacle = makeObstacle(this.#world, collidable.id, collidable);
    collidable.obstacle = obstacle;
    this.#byCollidable.set(collidable, obstacle);
  }

  #remove(collidable: CollidableNode, obstacle: ObstacleNode): void {
    this.#byCollidable.delete(collidable);
    collidable.obstacle = undefined;
    obstacle.discard();
  }

  /** Before the Bullet world goes. */
  clear(): void {
    for (const [collidable, obstacle] of this.#byCollidable) this.#remove(collidable, obstacle);
    this.#due = true;
  }
}
