import { MANIFOLD_POINT as POINT, BODY } from '../engine/offsets.js';
import type { BodyNode } from '../nodes/body.js';
import type { ContactParameters } from '../nodes/collision-collection.js';
import type { PhysicsNode } from '../nodes/node.js';
import type { World } from '../world/world.js';
import { Effect } from './effect.js';

/** Bullet's own contact processing threshold: no contact is left out. */
const UNLIMITED = 1e18;

/**
 * Writes a CollisionCollection's parameters into every contact of its pairs, between Bullet's contact search and its
 * solver. Without a collection that says more than the default this effect is off and costs nothing.
 */
export class ContactSurface extends Effect {
  readonly name = 'contact surface';
  readonly #world: World;
  /** By pointer of the first body, then of the second. Null: the pair has no parameters of its own. */
  #pairs = new Map<number, Map<number, ContactParameters | null>>();
  readonly #bouncing = new Set<BodyNode>();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** Some other collection speaks for the body now. */
  update(body: BodyNode): void {
    this.#pairs = new Map();
    const collections = this.#world.pairs.collectionsOf(body);
    if (collections.length === 0) {
      this.drop(body);
      return;
    }
    this.need(body, `collidable of ${collections[0]!.label}`);
    this.#setBouncing(
      body,
      collections.some(({ parameters }) => parameters.bounce > 0),
    );
  }

  override drop(node: PhysicsNode): void {
    super.drop(node);
    this.#pairs = new Map();
    this.#bouncing.delete(node as BodyNode);
  }

  /**
   * Bullet solves contacts before bodies touch and pushes overlaps apart by velocity; both falsify a bounce. A body
   * that bounces asks for neither (measured).
   */
  #setBouncing(body: BodyNode, bounces: boolean): void {
    if (bounces === this.#bouncing.has(body)) return;
    const before = this.anyBounce;
    if (bounces) this.#bouncing.add(body);
    else this.#bouncing.delete(body);
    body.body.setContactProcessingThreshold(bounces ? 0 : UNLIMITED);
    if (this.anyBounce !== before) this.#world.configureSolver();
  }

  get anyBounce(): boolean {
    return this.#bouncing.size > 0;
  }

  /** Called by Bullet for every contact point of every step: no allocation here. */
  process(point: number, a: number, b: number): void {
    const parameters = this.#parametersOf(a, b);
    if (!parameters) return;
    const heap = this.#world.engine.ammo.HEAPF32;
    const p = point >> 2;
    heap[p + (POINT.friction >> 2)] = parameters.friction;
    const fast = parameters.bounce > 0 && approachSpeed(heap, p, a, b) >= parameters.minBounceSpeed;
    heap[p + (POINT.restitution >> 2)] = fast ? parameters.bounce : 0;
  }

  #parametersOf(a: number, b: number): ContactParameters | null {
    let byB = this.#pairs.get(a);
    if (!byB) this.#pairs.set(a, (byB = new Map()));
    let parameters = byB.get(b);
    if (parameters === undefined) byB.set(b, (parameters = this.#find(a, b)));
    return parameters;
  }

  #find(a: number, b: number): ContactParameters | null {
    const first = this.#world.bodyAt(a);
    const second = this.#world.bodyAt(b);
    return (first && second && this.#world.pairs.of(first, second)?.parameters) ?? null;
  }
}

/** Speed at which the two surfaces near each other at a contact point, m/s. All indices are in 4-byte words. */
function approachSpeed(heap: Float32Array, p: number, a: number, b: number): number {
  let speed = 0;
  for (let i = 0; i < 3; i++) {
    speed +=
      heap[p + (POINT.normalB >> 2) + i]! *
      (pointVelocity(heap, p, b >> 2, i) - pointVelocity(heap, p, a >> 2, i));
  }
  return speed;
}

/** Component `i` of the velocity of a body's material at the contact point. */
function pointVelocity(heap: Float32Array, p: number, body: number, i: number): number {
  const j = (i + 1) % 3;
  const k = (i + 2) % 3;
  const at = p + (POINT.positionB >> 2);
  const origin = body + (BODY.origin >> 2);
  const w = body + (BODY.angularVelocity >> 2);
  const v = heap[body + (BODY.linearVelocity >> 2) + i]!;
  return (
    v +
    heap[w + j]! * (heap[at + k]! - heap[origin + k]!) -
    heap[w + k]! * (heap[at + j]! - heap[origin + j]!)
  );
}
