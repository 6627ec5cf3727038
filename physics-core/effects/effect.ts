import type { PhysicsNode } from '../nodes/node.js';

/** Weight of the newest step in the running mean of an effect's cost. */
const NEWEST = 0.05;

/** Who needs an effect: a node, or something outside the world that `world.effects` is to name. */
export type Cause = Pick<PhysicsNode, 'host'>;

/** Something a plain scene of falling bodies can do without. It runs while at least one node causes it. */
export abstract class Effect {
  abstract readonly name: string;
  /** Why it is on: the nodes that need it, and what of them. */
  readonly #causes = new Map<Cause, string>();
  /** Milliseconds per step, a running mean, and those of the present step. */
  ms = 0;
  spent = 0;

  get active(): boolean {
    return this.#causes.size > 0;
  }

  /** The first cause, for people. */
  get because(): { node: Cause; reason: string } | undefined {
    const first = this.#causes.entries().next().value;
    return first && { node: first[0], reason: first[1] };
  }

  get causes(): IterableIterator<Cause> {
    return this.#causes.keys();
  }

  /** The step is over. */
  noteCost(): void {
    this.ms += (this.spent - this.ms) * NEWEST;
    this.spent = 0;
  }

  isNeededBy(node: Cause): boolean {
    return this.#causes.has(node);
  }

  need(node: Cause, reason: string): void {
    this.#causes.set(node, reason);
  }

  drop(node: Cause): void {
    this.#causes.delete(node);
  }

  /** Before each step of Bullet, `dt` seconds. */
  beforeStep?(dt: number): void;
  /** Right after each step of Bullet, before anybody reads where it took the bodies. */
  settle?(dt: number): void;
  /** After each step of Bullet. */
  afterStep?(dt: number): void;
}
