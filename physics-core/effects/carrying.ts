import type { BodyNode } from '../nodes/body.js';
import type { World } from '../world/world.js';
import { Effect } from './effect.js';

/** Seconds without a new pose after which a carried body counts as standing still. */
const STILL = 0.1;

/**
 * Fixed bodies that are moved along (a ROUTE, an animated Transform above): kinematic for Bullet while they move, so
 * that they push and drag what they touch. At rest they are static again, since nothing may sleep on a kinematic body.
 */
export class Carrying extends Effect {
  readonly name = 'carrying';
  readonly #world: World;
  readonly #since = new Map<BodyNode, number>();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  carried(body: BodyNode): void {
    this.#since.set(body, this.#world.time);
    this.need(body, 'position');
  }

  override drop(body: BodyNode): void {
    super.drop(body);
    this.#since.delete(body);
  }

  override afterStep(): void {
    for (const [body, since] of this.#since) {
      if (this.#world.time - since < STILL) continue;
      this.drop(body);
      body.standStill();
    }
  }
}
