import { ContactPoint } from '../engine/contact-point.js';
import { MANIFOLD_POINT as POINT } from '../engine/offsets.js';
import type { BodyNode } from '../nodes/body.js';
import { isDirected, type ContactParameters } from '../nodes/contact-parameters.js';
import type { World } from '../world/world.js';
import { isBallAt } from './contact-part.js';
import { Response } from './contact-response.js';
import type { Pair } from './contact-rows.js';
import { Effect } from './effect.js';

/** Below this approach a hit is over: what bounces less and less would go on for ever, m/s. */
const OVER = 1e-3;

/** Hits that one blow may lead to. */
const MOST_HITS = 200;

/** A point where something round touches and bounces. */
class Hit {
  readonly point: ContactPoint;
  a!: Link;
  b!: Link;
  bounce = 0;
  /** Approach speed that bounces at least, m/s. */
  least = 0;
  /** Metres; what is apart is hit where it would be within the step. */
  gap = 0;
  /** N s that went through it in this step. */
  impulse = 0;
  /** It comes, and may yet turn out to be the first of a chain. */
  waits = false;
  /** Part of the chain that is being worked out. */
  chained = false;

  constructor(world: World) {
    this.point = new ContactPoint(world.engine.ammo);
  }

  get approach(): number {
    const { point } = this;
    return -point.speed(point.normal(0), point.normal(1), point.normal(2));
  }

  /** Whether it happens in this step of `dt` seconds. */
  comes(dt: number): boolean {
    const { approach } = this;
    return approach >= this.least && this.gap <= approach * dt;
  }
}

/** A body that is hit, and where. */
class Link {
  readonly response = new Response();
  readonly hits: Hit[] = [];
  body!: BodyNode;
  movable = false;
  /** The step that it belongs to. */
  step = -1;
  /** Whether its response is known in this step. */
  known = false;
}

/**
 * A blow goes through touching balls as one hit after the other, the hardest first: the far ball of a cradle takes over
 * the swing. Bullet has all of them bounce at once, and a touching row goes on together. Where a ball that is hit
 * touches a further one, this hands the blow on between Bullet's contact search and its solver, which then finds
 * nothing left to do. Single hits, and what touches in several points, are Bullet's.
 */
export class ContactChains extends Effect {
  readonly name = 'chains of hits';
  readonly #world: World;
  /** Kept from step to step, so that a contact allocates nothing. */
  readonly #hits: Hit[] = [];
  /** By slot of the body. */
  readonly #links: Link[] = [];
  readonly #chain: Hit[] = [];
  #count = 0;
  #steps = 0;
  #dt = 0;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  /** As long as something bounces. */
  override get active(): boolean {
    return this.#world.registry.surface.demands.bouncing;
  }

  override get because(): Effect['because'] {
    return this.active ? this.#world.registry.surface.because : undefined;
  }

  override beforeStep(dt: number): void {
    this.#dt = dt;
    this.#count = 0;
    this.#steps++;
  }

  /** What went through the points belongs to what listeners hear of them. */
  override afterStep(): void {
    for (let i = 0; i < this.#count; i++) {
      const { point, impulse } = this.#hits[i]!;
      if (impulse > 0) point.refresh().put(POINT.impulse, point.get(POINT.impulse) + impulse);
    }
  }

  /** A contact point of this step, called before Bullet solves it. */
  note(at: ContactPoint, pair: Pair, parameters: ContactParameters): void {
    const { bounce, minBounceSpeed, softness } = parameters;
    if (bounce === 0 || softness > 0 || isDirected(parameters)) return;
    const { ammo } = this.#world.engine;
    const { a, b } = pair;
    if (!isBallAt(ammo, a, at.pointer, 0) && !isBallAt(ammo, b, at.pointer, 1)) return;
    const hit = (this.#hits[this.#count++] ??= new Hit(this.#world));
    hit.point.at(at.pointer, a.pointer, b.pointer);
    hit.a = this.#linkOf(a);
    hit.b = this.#linkOf(b);
    hit.bounce = bounce;
    hit.least = Math.max(minBounceSpeed, OVER);
    hit.gap = at.distance;
    hit.impulse = 0;
    if (hit.a.movable) hit.a.hits.push(hit);
    if (hit.b.movable) hit.b.hits.push(hit);
    hit.waits = hit.comes(this.#dt);
    if (this.#isChain(hit)) this.#handOn(hit);
  }

  #linkOf(body: BodyNode): Link {
    const link = (this.#links[body.slot] ??= new Link());
    if (link.step === this.#steps) return link;
    link.step = this.#steps;
    link.body = body;
    link.movable = body.movable;
    link.hits.length = 0;
    link.known = false;
    return link;
  }

  /** Whether it or a neighbour of it comes, they are of three bodies, and one of the two is between bodies that move. */
  #isChain(hit: Hit): boolean {
    const { a, b } = hit;
    return this.#goesOn(hit, a, b) || this.#goesOn(hit, b, a);
  }

  #goesOn(hit: Hit, link: Link, other: Link): boolean {
    const both = link.movable && other.movable;
    for (const next of link.hits) {
      const third = next.a === link ? next.b : next.a;
      if (third !== other && (hit.waits || next.waits) && (both || third.movable)) return true;
    }
    return false;
  }

  // ---- a blow ---------------------------------------------------------------------------------------------------------

  #handOn(first: Hit): void {
    this.#chain.length = 0;
    this.#joinAll(first);
    for (let i = 0; i < MOST_HITS; i++) {
      const hit = this.#hardest();
      if (!hit) break;
      this.#strike(hit);
      this.#joinAll(hit);
    }
    for (const hit of this.#chain) hit.chained = hit.waits = false;
  }

  #joinAll({ a, b }: Hit): void {
    for (const hit of a.hits) this.#join(hit);
    for (const hit of b.hits) this.#join(hit);
  }

  #join(hit: Hit): void {
    if (hit.chained) return;
    hit.chained = true;
    hit.point.refresh();
    this.#chain.push(hit);
  }

  #hardest(): Hit | undefined {
    let hardest: Hit | undefined;
    for (const hit of this.#chain)
      if (hit.comes(this.#dt) && !(hardest && hit.approach <= hardest.approach)) hardest = hit;
    return hardest;
  }

  #strike(hit: Hit): void {
    const { point, bounce } = hit;
    const { approach } = hit;
    const [x, y, z] = [point.normal(0), point.normal(1), point.normal(2)];
    const impulse = ((1 + bounce) * approach) / this.#ease(hit, x, y, z);
    if (!Number.isFinite(impulse)) return;
    this.#push(hit, impulse);
    hit.impulse += impulse;
    this.#rub(hit, impulse * point.get(POINT.friction));
    // What is left is no bounce any more.
    point.put(POINT.restitution, 0);
    point.put(POINT.impulse, 0);
  }

  /** Coulomb's friction of the hit: against the sliding, and no more than ends it. */
  #rub(hit: Hit, most: number): void {
    const { point } = hit;
    const [x, y, z] = [point.normal(0), point.normal(1), point.normal(2)];
    const out = -hit.approach;
    const u = point.speed(1, 0, 0) - out * x;
    const v = point.speed(0, 1, 0) - out * y;
    const w = point.speed(0, 0, 1) - out * z;
    const sliding = Math.hypot(u, v, w);
    if (sliding < OVER) return;
    const ease = this.#ease(hit, u / sliding, v / sliding, w / sliding);
    this.#push(hit, -Math.min(most, sliding / ease));
  }

  /** How far both give way along a direction, 1/kg. */
  #ease({ point, a, b }: Hit, x: number, y: number, z: number): number {
    const { ammo } = this.#world.engine;
    return this.#known(a).ease(point, ammo, x, y, z) + this.#known(b).ease(point, ammo, x, y, z);
  }

  #known(link: Link): Response {
    if (!link.known) link.response.read(link.body, this.#world);
    link.known = true;
    return link.response;
  }

  #push({ a, b }: Hit, impulse: number): void {
    const { ammo } = this.#world.engine;
    a.response.push(ammo, impulse);
    b.response.push(ammo, -impulse);
  }
}
