import type { ContactPoint } from '../../engine/contact-point.js';
import { pairTestOf } from '../../engine/pair-test.js';
import type { Body } from '../../dynamics/body.js';
import { isDirected, type ContactParameters } from '../../dynamics/contact-parameters.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Blow, MOST_HITS } from './blow.js';
import { continuousCollision } from './effects.js';
import { hitShapeOf, type HitShape } from './hit-shape.js';
import { Impact, OVER } from './impact.js';
import { StruckBody } from './struck-body.js';
import { isBallAt, isRound, partOf } from '../contacts/contact-part.js';
import type { Pair } from '../contacts/contact-rows.js';
import { contactSurface, pairFilter } from '../contacts/effects.js';
import type { ContactListener, ContactSurface } from '../contacts/contact-surface.js';
import { Effect, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { jointSolve } from '../joints/effects.js';
import type { JointRows } from '../joints/joint-rows.js';
import { keyOf } from '../contacts/touches.js';
import { apartBetween } from '../../engine/body-heap.js';
import { breakingAt } from '../../engine/manifold-points.js';
import { anyFast, eachFastPair } from '../contacts/stale-contacts.js';

type KeptLink = [id: number, carried: boolean, borne: boolean];

/** Of places a few metres from the origin, metres: nearer than this, bodies touch. */
const ROUNDING = 1e-6;

/**
 * What is round hits in one point, at a time of its own within the step: its speed, what friction makes of it, and its way
 * from there are those of that time, so that a bounce is as high at every level. A blow goes on through touching balls as
 * one hit after the other, the earliest first: the far ball of a cradle takes over the swing, where Bullet has all of them
 * bounce at once. All this happens between Bullet's contact search and its solver, which then finds nothing left to do.
 * What touches in several points, and what rests, is Bullet's.
 */
export class ImpactPropagation extends Effect implements ContactListener {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #surface: ContactSurface;
  #rows: JointRows | undefined;
  /** Kept from step to step, so that a contact allocates nothing. */
  readonly #hits: Impact[] = [];
  /** By slot of the body. */
  readonly #links: StruckBody[] = [];
  readonly #blow: Blow;
  /** Of the step that runs. */
  readonly #touched: StruckBody[] = [];
  /** Pairs that were looked at again in this step. */
  readonly #seen = new Set<number>();
  #count = 0;
  /** Rounds of looking, several in a step of Bullet. */
  #steps = 0;
  #bulletSteps = 0;
  #dt = 0;
  /** Hits up to this time of the step happen now. */
  #until = 0;
  /** What is noted lay on the way of something fast. */
  #swept = false;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#blow = new Blow(simulation.engine);
    this.#surface = effects.get(contactSurface);
    this.#surface.listener = this;
  }

  /** The world begins anew: what bore a body in the last step says nothing of the next one. */
  override reset(): void {
    this.#bulletSteps++;
  }

  /** Who was borne in the last step, and by what. */
  override save(): KeptLink[] | undefined {
    const kept: KeptLink[] = [];
    for (const { id, slot } of this.#simulation.bodies) {
      const link = this.#links[slot];
      if (link?.isKnownIn(this.#bulletSteps)) kept.push([id, link.carried, link.borne]);
    }
    return kept.length > 0 ? kept : undefined;
  }

  override load(kept: readonly KeptLink[], nodes: Numbered): void {
    for (const [id, carried, borne] of kept) {
      const slot = nodes.body(id)?.slot ?? -1;
      if (slot < 0) continue;
      const link = (this.#links[slot] ??= new StruckBody(this.#simulation.engine, this.#jointRows));
      link.goOn(this.#bulletSteps, carried, borne);
    }
  }

  readonly #jointRows = (): JointRows => (this.#rows ??= this.#effects.get(jointSolve).newRows());

  override beforeStep(dt: number): void {
    this.#dt = this.#until = dt;
    this.#count = 0;
    this.#bulletSteps++;
    this.#blow.slop = this.#simulation.bullet.settings.linearSlop;
    this.#newRound();
  }

  /** A contact point of this step, called before Bullet solves it. */
  note(at: ContactPoint, pair: Pair, parameters: ContactParameters): void {
    const { bounce, minBounceSpeed, softness } = parameters;
    if (softness > 0 || isDirected(parameters)) return;
    const { a, b } = pair;
    const round = isBallAt(at, a, 0) || isBallAt(at, b, 1);
    if (!round && !this.#swept && bounce === 0) return;
    const hit = (this.#hits[this.#count++] ??= new Impact(this.#simulation.engine));
    hit.point.at(at.pointer, a.pointer, b.pointer);
    hit.a = this.#linkOf(a);
    hit.b = this.#linkOf(b);
    hit.bounce = bounce;
    hit.least = Math.max(minBounceSpeed, OVER);
    hit.shapeA = this.#shapeOf(at, a, b, 0);
    hit.shapeB = this.#shapeOf(at, a, b, 1);
    hit.begin(at.distance, this.#dt);
    if (!this.#swept) this.#blow.timeOfImpact.measure(hit, this.#dt);
    const alone = round && !hit.a.hangs && !hit.b.hangs;
    if (alone || this.#swept) this.#meet(hit);
    else this.#leave(hit);
  }

  /** What touches in several points, or has others hanging on it, bounces in Bullet's solver: off all of them at once. */
  #leave(hit: Impact): void {
    const { point, a, b } = hit;
    // After Bullet's step it is too late.
    if (this.#until === 0) return;
    const share = hit.comes(this.#dt, this.#until) ? hit.shareAt(this.#dt) : 0;
    point.restitution = share;
    if (share === 0) return;
    // Neither a gap to close nor a depth to push out: the body is moved after the step.
    point.solverDistance = -this.#blow.slop;
    if (a.movable) a.bounce(hit.time);
    if (b.movable) b.bounce(hit.time);
  }

  #meet(hit: Impact): void {
    if (hit.a.movable) hit.a.hits.push(hit);
    if (hit.b.movable) hit.b.hits.push(hit);
    if (hit.comes(this.#dt, this.#until)) this.#blow.handOn(hit, this.#dt, this.#until);
    // What rests comes no more back in Bullet's solver than here.
    else if (hit.point.solverDistance <= ROUNDING) hit.handOver(this.#blow.slop);
  }

  /** Where a sweep says what was met it may be another part. */
  #shapeOf(at: ContactPoint, a: Body, b: Body, side: 0 | 1): HitShape | undefined {
    const body = side === 0 ? a : b;
    if (this.#swept && body.solidParts.length > 1) return undefined;
    const part = partOf(at, body, side);
    return part && hitShapeOf(part, body);
  }

  #linkOf(body: Body): StruckBody {
    const link = (this.#links[body.slot] ??= new StruckBody(
      this.#simulation.engine,
      this.#jointRows,
    ));
    if (link.step !== this.#steps) {
      link.take(body, this.#steps, this.#bulletSteps, this.#until > 0);
      this.#touched.push(link);
    }
    return link;
  }

  // ---- the way of the step -----------------------------------------------------------------------------------------------

  /**
   * Bullet moves a body with the speed it has at the end of the step. Hits act at their own time of it, and weight and
   * what carries it all along.
   */
  override settle(dt: number): void {
    const { engine, bullet } = this.#simulation;
    const struck = this.#blow.strikes > 0;
    for (const link of this.#touched) link.weigh(dt);
    this.#makeUpAll(dt);
    pairTestOf(engine).clear(bullet.bullet);
    this.#until = 0;
    if (struck || anyFast(this.#simulation, dt)) this.#lookAgain(dt);
    this.#noteImpulses();
  }

  /**
   * What went through the points belongs to what listeners hear of them. It is written before bodies are read: the points
   * of one that is taken out then, since it has no finite numbers, are freed.
   */
  #noteImpulses(): void {
    for (let i = 0; i < this.#count; i++) {
      const { point, impulse } = this.#hits[i]!;
      if (impulse > 0) point.refresh().impulse += impulse;
    }
  }

  /**
   * Bullet finds contacts at the start of a step, and balls only once they overlap: what comes fast would be seen inside the
   * other body, or behind it, before it is turned back. So that is looked at once more, then what it was turned into.
   */
  #lookAgain(dt: number): void {
    const continuous = this.#effects.find(continuousCollision);
    if (continuous?.active) {
      this.#newRound();
      this.#swept = true;
      continuous.look(this.#process);
      this.#swept = false;
      this.#makeUpAll(dt);
    }
    this.#newRound();
    eachFastPair(this.#simulation, dt, this.#lookAt);
    this.#lookBehindAll();
    for (let i = 0; i < MOST_HITS && this.#blow.strikes > 0; i++) {
      this.#makeUpAll(dt);
      this.#newRound();
      this.#lookBehindAll();
    }
    this.#touched.length = 0;
  }

  #newRound(): void {
    this.#steps++;
    this.#blow.strikes = 0;
    this.#seen.clear();
  }

  /** Bodies are fewer than pairs: mostly none was turned back. */
  #lookBehindAll(): void {
    const round = this.#steps - 1;
    if (this.#links.some((link) => link.struckIn === round))
      this.#simulation.bullet.eachPair(this.#lookBehind);
  }

  /** What was turned back in the round before may lie against something. */
  readonly #lookBehind = (_: number, a: number, b: number): void => {
    if (this.#struckIn(a, this.#steps - 1) || this.#struckIn(b, this.#steps - 1))
      this.#lookAt(_, a, b);
  };

  readonly #lookAt = (manifold: number, a: number, b: number): void => {
    const { engine, bullet } = this.#simulation;
    const first = this.#simulation.bodyAt(a);
    const second = this.#simulation.bodyAt(b);
    if (!first || !second || !(isRound(first) || isRound(second))) return;
    const met = first.reach + second.reach + 2 * breakingAt(engine.ammo, manifold);
    if (apartBetween(engine.ammo, a, b) > met) return;
    const key = keyOf(first, second);
    if (this.#seen.has(key)) return;
    this.#seen.add(key);
    const pairTest = pairTestOf(engine);
    const from = pairTest.count;
    pairTest.touch(first.body, second.body);
    pairTest.each(bullet.bullet, this.#process, from);
  };

  /** A contact point that is none of Bullet's. */
  readonly #process = (point: number, a: number, b: number): void => {
    const filter = this.#effects.find(pairFilter);
    if (!filter?.active || filter.contact(point, a, b)) this.#surface.contact(point, a, b);
  };

  /** Whether it was hit in this step, as far as it is known. */
  struck({ pointer }: Body): boolean {
    return this.#struckIn(pointer, this.#steps);
  }

  #struckIn(pointer: number, round: number): boolean {
    const body = this.#simulation.bodyAt(pointer);
    return body !== undefined && this.#links[body.slot]?.struckIn === round;
  }

  #makeUpAll(dt: number): void {
    for (const link of this.#touched) link.makeUp(dt);
    this.#touched.length = 0;
  }
}
