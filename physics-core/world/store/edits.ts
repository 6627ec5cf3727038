import type { PhysicsNode } from '../../nodes/node/node.js';

/** Nodes are made and patched in this order: collections, collidables, bodies, joints, collision collections, sensors. */
export const RANKS = 6;

/** Nodes with edits that Bullet has not seen yet, by rank. */
export class Edits {
  readonly #queues: Set<PhysicsNode>[] = Array.from({ length: RANKS }, () => new Set());

  add(node: PhysicsNode): void {
    this.#queues[node.type.rank]!.add(node);
  }

  drop(node: PhysicsNode): void {
    this.#queues[node.type.rank]!.delete(node);
  }

  *[Symbol.iterator](): Generator<PhysicsNode> {
    for (const queue of this.#queues) yield* queue;
  }

  get pending(): boolean {
    return this.#queues.some((queue) => queue.size > 0);
  }

  /** Applies the next one, lowest rank first: an edit may cause others (a body's shape by its collidable). False: there is none. */
  applyNext(apply: (node: PhysicsNode) => void): boolean {
    const queue = this.#first();
    if (!queue) return false;
    const node = queue.values().next().value!;
    queue.delete(node);
    apply(node);
    return true;
  }

  #first(): Set<PhysicsNode> | undefined {
    return this.#queues.find((queue) => queue.size > 0);
  }
}
