import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';

/** Collections that ask to be drawn as Bullet has them. Who draws hears of it by the world's `debug`. */
export class Debugging extends Effect {
  readonly name = 'debug drawing';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** `debug` of a collection. */
  set(node: PhysicsNode, on: boolean): void {
    const before = this.active;
    if (on) this.need(node, 'debug');
    else this.drop(node);
    if (this.active !== before) this.#world.emit('debug', this.active);
  }

  /** What is drawn is no longer true. */
  stale(): void {
    if (this.active) this.#world.work();
  }
}
