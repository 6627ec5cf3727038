import type { HeapLimit } from './heap-limit.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';

/**
 * What becomes of a node that fails while it is made or patched: nothing of it stays in Bullet, its author is told, and
 * its next edit tries again. The others go on.
 */
export class Failures {
  readonly #world: NodeWorld;
  readonly #heapLimit: HeapLimit;
  readonly #failed = new WeakSet<PhysicsNode>();

  constructor(world: NodeWorld, heapLimit: HeapLimit) {
    this.#world = world;
    this.#heapLimit = heapLimit;
  }

  attempt(node: PhysicsNode, act: () => void): void {
    try {
      act();
      this.#settle(node);
    } catch (error) {
      this.#failed.add(node);
      this.#undo(node);
      if (this.#world.engine.isExhaustion(error)) this.#heapLimit.exhausted(node);
      else this.#tell(node, error);
    }
  }

  #undo(node: PhysicsNode): void {
    try {
      node.abandon();
    } catch {
      // It counts as unmade all the same.
    }
  }

  #settle(node: PhysicsNode): void {
    if (!this.#failed.delete(node)) return;
    for (const code of ['edit-failed', 'heap-exhausted']) node.settle(undefined, code);
    this.#heapLimit.made(node);
  }

  #tell(node: PhysicsNode, error: unknown): void {
    node.report({
      code: 'edit-failed',
      severity: 'error',
      value: String(error),
      used: 'nothing',
      message: `${node.label} could not be simulated (${String(error)}), which is a fault of x3d-physics; it is left out until its next edit`,
    });
  }
}
