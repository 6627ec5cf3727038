import type { NodeWorld } from '../../nodes/node/node-world.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import type { LevelControl } from '../accuracy/level-control.js';
import type { Awaiting } from './awaiting.js';
import { Edits } from './edits.js';
import type { HeapLimit } from './heap-limit.js';
import type { ObstacleRules } from '../pairs/alone.js';

/** The world whose nodes are edited. */
interface EditedWorld extends NodeWorld {
  readonly obstacles: ObstacleRules;
}

const NONE: readonly unknown[] = [];

/** The road of edits: nodes that changed are made or patched in one batch, and what follows from that. */
export class Editing {
  readonly #world: EditedWorld;
  readonly #edits = new Edits();
  readonly #awaiting: Awaiting;
  readonly #heapLimit: HeapLimit;
  readonly #control: LevelControl;

  constructor(world: EditedWorld, awaiting: Awaiting, heapLimit: HeapLimit, control: LevelControl) {
    this.#world = world;
    this.#awaiting = awaiting;
    this.#heapLimit = heapLimit;
    this.#control = control;
  }

  add(node: PhysicsNode): void {
    this.#edits.add(node);
  }

  drop(node: PhysicsNode): void {
    this.#edits.drop(node);
  }

  get pending(): boolean {
    return this.#edits.pending;
  }

  flush(): void {
    this.#world.events.call(this.#world, 'flush', NONE, this.#applyAll);
  }

  /** Obstacles are edits in their turn; a level that is another now is told once all is applied. */
  readonly #applyAll = (): void => {
    if (this.#awaiting.holds(this.#edits)) return;
    while (this.applyNext());
    this.#control.tell();
  };

  /** False: there is none, and no obstacle is to be made. */
  applyNext(): boolean {
    return this.#edits.applyNext(this.#apply) || this.#world.obstacles.update();
  }

  readonly #apply = (node: PhysicsNode): void =>
    this.#world.failures.attempt(node, () => {
      if (!node.built) this.#heapLimit.check();
      node.apply();
    });
}
