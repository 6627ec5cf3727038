import type { ContactProcessor } from '../engine/contact-hook.js';
import { MANIFOLD_POINT as POINT } from '../engine/offsets.js';
import type { BodyNode } from '../nodes/body.js';
import type { PhysicsNode } from '../nodes/node.js';
import type { World } from '../world/world.js';
import { partAt } from './contact-part.js';
import { Effect } from './effect.js';

/** Farther than any contact that Bullet's solver looks at (its own threshold is 1e18), metres. */
const APART = 1e30;

/** Parts of one body that are told apart by their numbers. */
const MOST_PARTS = 4096;

/**
 * Takes contacts back whose collidables do not collide, where Bullet's 15 group bits can't keep their bodies apart: a
 * point so far away is no contact for the solver.
 */
export class PairFilter extends Effect implements ContactProcessor {
  readonly name = 'pair filter';
  readonly #world: World;
  /** What contacts go to that stay. */
  next: ContactProcessor | null = null;
  /** By pointer of the first body, of the second, and both parts: whether they meet. */
  #known = new Map<number, Map<number, Map<number, boolean>>>();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** Who meets whom is to be asked again. */
  forget(): void {
    this.#known = new Map();
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
    const { ammo } = this.#world.engine;
    const heap = ammo.HEAP32;
    // A triangle's number says nothing of the part it belongs to.
    const mesh = heap[(point + POINT.part0) >> 2]! >= 0 || heap[(point + POINT.part1) >> 2]! >= 0;
    const i = heap[(point + POINT.index0) >> 2]!;
    const j = heap[(point + POINT.index1) >> 2]!;
    const meets = mesh ? this.#find(a, b, point) : this.#meets(a, b, i, j, point);
    if (meets) this.next?.process(point, a, b);
    else ammo.HEAPF32[(point + POINT.distance) >> 2] = APART;
  }

  #meets(a: number, b: number, i: number, j: number, point: number): boolean {
    let byB = this.#known.get(a);
    if (!byB) this.#known.set(a, (byB = new Map()));
    let byParts = byB.get(b);
    if (!byParts) byB.set(b, (byParts = new Map()));
    const key = (i + 1) * MOST_PARTS + j + 1;
    let meets = byParts.get(key);
    if (meets === undefined) byParts.set(key, (meets = this.#find(a, b, point)));
    return meets;
  }

  #find(pointerA: number, pointerB: number, point: number): boolean {
    const bodies = [pointerA, pointerB].map((pointer) => this.#world.bodyAt(pointer));
    const [a, b] = bodies as [BodyNode | undefined, BodyNode | undefined];
    if (!a || !b) return true;
    const { ammo } = this.#world.engine;
    const [first, second] = [partAt(ammo, a, point, 0), partAt(ammo, b, point, 1)];
    return !first || !second || this.#world.pairs.meet(a, first, b, second);
  }
}
