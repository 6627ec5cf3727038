import type { ContactProcessor } from '../../engine/contact-hook.js';
import { MANIFOLD_POINT as POINT } from '../../engine/offsets.js';
import type { BodyNode } from '../../nodes/body.js';
import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { partAt, partsAt } from './contact-part.js';
import { Effect } from '../effect.js';

/** Farther than any contact that Bullet's solver looks at (its own threshold is 1e18), metres. */
const APART = 1e30;

/** Two bodies, and which of their parts meet, by the number of both. */
interface Neighbours {
  a: BodyNode;
  b: BodyNode;
  byParts: Map<number, boolean>;
}

/**
 * Takes contacts back whose collidables do not collide, where Bullet's 15 group bits can't keep their bodies apart: a
 * point so far away is no contact for the solver.
 */
export class PairFilter extends Effect implements ContactProcessor {
  readonly name = 'pair filter';
  readonly #world: World;
  /** What contacts go to that stay. */
  next: ContactProcessor | null = null;
  /** By pointer of the first body, then of the second. */
  readonly #known = new Map<number, Map<number, Neighbours>>();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** Who meets whom is to be asked again: membership or parts are others. */
  forget(): void {
    this.#known.clear();
  }

  override need(node: PhysicsNode, reason: string): void {
    super.need(node, reason);
    this.forget();
  }

  override drop(node: PhysicsNode): void {
    super.drop(node);
    this.forget();
  }

  /** Called by Bullet for every contact point of every step. */
  process(point: number, a: number, b: number): void {
    if (this.#meet(point, a, b)) this.next?.process(point, a, b);
    else this.#world.engine.ammo.HEAPF32[(point + POINT.distance) >> 2] = APART;
  }

  #meet(point: number, pointerA: number, pointerB: number): boolean {
    const neighbours = this.#neighbours(pointerA, pointerB);
    if (!neighbours) return true;
    const { a, b, byParts } = neighbours;
    const parts = partsAt(this.#world.engine.ammo, a, b, point);
    let meet = byParts.get(parts);
    if (meet === undefined) byParts.set(parts, (meet = this.#ask(neighbours, point)));
    return meet;
  }

  #neighbours(pointerA: number, pointerB: number): Neighbours | undefined {
    let byB = this.#known.get(pointerA);
    if (!byB) this.#known.set(pointerA, (byB = new Map()));
    let found = byB.get(pointerB);
    if (found) return found;
    const [a, b] = [this.#world.bodyAt(pointerA), this.#world.bodyAt(pointerB)];
    if (!a || !b) return undefined;
    byB.set(pointerB, (found = { a, b, byParts: new Map() }));
    return found;
  }

  #ask({ a, b }: Neighbours, point: number): boolean {
    const { ammo } = this.#world.engine;
    const [first, second] = [partAt(ammo, a, point, 0), partAt(ammo, b, point, 1)];
    return !first || !second || this.#world.pairs.meet(a, first, b, second);
  }
}
