import { ContactPoint } from '../../engine/contact-point.js';
import { pointAfter } from '../../engine/manifold.js';
import type { Body } from '../../dynamics/body.js';
import type { Collidable } from '../../dynamics/collidable.js';
import {
  isPlain,
  isSoft,
  isSpecial,
  PLAIN,
  type ContactParameters,
} from '../../dynamics/contact-parameters.js';
import { carriedBy } from '../../dynamics/contact-order.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { partAt, partsAt } from './contact-part.js';
import { isJointedPair, writeDepth } from './contact-depth.js';
import { FAR, leaveOut, writeSurface, type Pair, type StepState } from './contact-rows.js';
import { Effect, type Cause, type Numbered } from '../effect/effect.js';
import { anyFast, forgetStale } from './stale-contacts.js';
import { DemandCount, demandsOf, union } from './demand-count.js';
import { NO_DEMANDS, type SolverDemands } from './solver-demands.js';

/** Numbers of a linear velocity. */
const VELOCITY = 3;

/** For a snapshot: by the ids of bodies. */
interface KeptSurface {
  leaving: number[];
  bodies: [id: number, change: number[]][];
  pairs: [a: number, b: number, impulse: number[]][];
}

/** Told of every contact point that has parameters, between Bullet's contact search and its solver. */
export interface ContactListener {
  note(point: ContactPoint, pair: Pair, parameters: ContactParameters): void;
}

/** Says of single points what they are like. Null leaves a point out; undefined: nothing is said of it. */
export interface ContactOverrides {
  at(point: ContactPoint, pair: Pair): ContactParameters | null | undefined;
}

/**
 * Writes a CollisionCollection's parameters into every contact of its pairs, between Bullet's contact search and its
 * solver. Without a collection that says more than the default this effect is off and costs nothing.
 */
export class ContactSurface extends Effect {
  readonly #simulation: Simulation;
  readonly #demands = new Map<Cause, SolverDemands>();
  readonly #count = new DemandCount();
  /** What is told of every point, once its surface is written. */
  listener: ContactListener | undefined;
  /** What is said of single points for the step that runs, and what that demands. */
  #overrides: ContactOverrides | undefined;
  #given: SolverDemands | undefined;
  /** Points whose distance was written for the solver in this step; and those that only Bullet's solver can do. */
  readonly written = new Set<number>();
  readonly special = new Set<number>();
  /** Of all that need it. */
  demands = NO_DEMANDS;
  #limiting: Cause | undefined;
  /** Bodies that need it for one step more: points keep what was written into them. */
  readonly #leaving = new Set<Body>();
  /** By pointer of the first body, then of the second. */
  #pairs = new Map<number, Map<number, Pair>>();
  #point: ContactPoint | undefined;
  #steps = 0;
  readonly #velocity = new Float64Array(2 * VELOCITY);
  #before = new Float64Array(VELOCITY * 16);
  readonly #step: StepState = {
    dt: 0,
    slop: 0,
    maxCorrectionSpeed: Infinity,
    changes: new Float64Array(VELOCITY * 16),
  };

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  // ---- who needs it -----------------------------------------------------------------------------------------------

  /** Some other collection speaks for the body now, or says something else. */
  update(body: Body): void {
    this.#pairs.clear();
    this.#step.changes.fill(0, body.slot * VELOCITY, (body.slot + 1) * VELOCITY);
    const collections = this.#simulation.pairs.collectionsOf(body);
    const speaking = collections.filter(({ parameters }) => !isPlain(parameters));
    const waits = this.#simulation.pairs.waits(body);
    this.#leaving.delete(body);
    if (waits && speaking.length === 0)
      this.demand(body, 'contacts that wait for set_contacts', []);
    else if (speaking.length > 0)
      this.demand(
        body,
        `collidable of ${speaking[0]!.label}`,
        speaking.map(({ parameters }) => demandsOf(parameters)),
      );
    else if (this.#demands.has(body)) {
      this.demand(body, 'contacts of a former collection', []);
      this.#leaving.add(body);
    }
  }

  /** maxCorrectionSpeed of the world; Infinity: no limit. Told with every edit of the collection. */
  limit(collection: Cause, speed: number): void {
    if (collection === this.#limiting && speed === this.#step.maxCorrectionSpeed) return;
    if (this.#limiting) this.release(this.#limiting);
    this.#limiting = collection;
    this.#step.maxCorrectionSpeed = speed;
    if (speed < Infinity)
      this.demand(collection, 'maxCorrectionSpeed', [{ ...NO_DEMANDS, pushing: true }]);
  }

  demand(node: Cause, reason: string, demands: SolverDemands[]): void {
    this.need(node, reason);
    this.#setDemands(node, union(demands));
  }

  /** Contacts that page code gave for the step that comes; undefined: that step is over. They are no cause of a body's. */
  demandGiven(given: Cause & ContactOverrides, demands: SolverDemands | undefined): void {
    if (demands) super.need(given, 'set_contacts');
    else super.release(given);
    this.#overrides = demands && given;
    this.#count.replace(this.#given, demands);
    this.#given = demands;
    this.#sumUp();
  }

  override release(node: Cause): void {
    super.release(node);
    this.#pairs.clear();
    this.#leaving.delete(node as Body);
    if (this.#demands.has(node)) this.#setDemands(node, undefined);
  }

  #setDemands(node: Cause, demands: SolverDemands | undefined): void {
    this.#count.replace(this.#demands.get(node), demands);
    if (demands) this.#demands.set(node, demands);
    else this.#demands.delete(node);
    this.#sumUp();
  }

  #sumUp(): void {
    const before = this.demands;
    this.demands = this.#count.union;
    const { pushing, directed } = this.demands;
    if (pushing !== before.pushing || directed !== before.directed)
      this.#simulation.configureSolver();
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  override reset(): void {
    this.#pairs.clear();
    this.#step.changes.fill(0);
    for (const body of this.#leaving) this.release(body);
  }

  /** What the last step gave bodies and pairs. */
  override save(): KeptSurface | undefined {
    const kept: KeptSurface = {
      leaving: [...this.#leaving].map(({ id }) => id),
      bodies: [],
      pairs: [],
    };
    if (this.demands.changes) {
      for (const { id, slot } of this.#simulation.bodies) {
        const at = slot * VELOCITY;
        const change = [...this.#step.changes.subarray(at, at + VELOCITY)];
        if (change.some(Boolean)) kept.bodies.push([id, change]);
      }
      for (const byB of this.#pairs.values())
        for (const { a, b, impulse, summed } of byB.values())
          if (summed === this.#steps) kept.pairs.push([a.id, b.id, [...impulse]]);
    }
    const { leaving, bodies, pairs } = kept;
    return leaving.length + bodies.length + pairs.length > 0 ? kept : undefined;
  }

  override load({ leaving, bodies, pairs }: KeptSurface, { body }: Numbered): void {
    for (const id of leaving) {
      const one = body(id);
      if (!one) continue;
      this.demand(one, 'contacts of a former collection', []);
      this.#leaving.add(one);
    }
    for (const [id, change] of bodies) {
      const slot = body(id)?.slot ?? -1;
      if (slot < 0) continue;
      if ((slot + 1) * VELOCITY > this.#before.length) this.#grow(slot);
      this.#step.changes.set(change, slot * VELOCITY);
    }
    for (const [first, second, impulse] of pairs) {
      const pair = this.#pairOf(body(first)?.pointer ?? 0, body(second)?.pointer ?? 0);
      if (!pair) continue;
      pair.impulse.set(impulse);
      pair.summed = this.#steps;
    }
  }

  // ---- around a step ----------------------------------------------------------------------------------------------

  override beforeStep(dt: number): void {
    this.written.clear();
    this.special.clear();
    this.#step.dt = dt;
    this.#step.slop = this.#simulation.bullet.settings.linearSlop;
    if (this.demands.changes) this.#eachVelocity(this.#noteBefore);
    if (anyFast(this.#simulation, dt)) forgetStale(this.#simulation, dt);
  }

  override afterStep(): void {
    if (this.demands.changes) {
      this.#eachVelocity(this.#noteChange);
      this.#sumImpulses();
    }
    for (const body of this.#leaving) if (!body.sleeping) this.release(body);
  }

  readonly #noteBefore = (value: number, at: number): void => {
    this.#before[at] = value;
  };

  readonly #noteChange = (value: number, at: number): void => {
    this.#step.changes[at] = value - this.#before[at]!;
  };

  /** Of all points of a pair. */
  #sumImpulses(): void {
    const step = ++this.#steps;
    this.#simulation.bullet.eachTouchingPair((first, count, a, b) => {
      const pair = this.#pairs.get(a)?.get(b);
      if (!pair) return;
      if (pair.summed !== step) pair.impulse.fill(0);
      pair.summed = step;
      for (let i = 0; i < count; i++) this.#at(pointAfter(first, i), a, b).addImpulse(pair.impulse);
    });
  }

  #eachVelocity(visit: (value: number, at: number) => void): void {
    const { reader } = this.#simulation.engine;
    for (const { slot, pointer } of this.#simulation.bodies) {
      if ((slot + 1) * VELOCITY > this.#before.length) this.#grow(slot);
      reader.velocity(pointer, this.#velocity, 0);
      for (let i = 0; i < VELOCITY; i++) visit(this.#velocity[i]!, slot * VELOCITY + i);
    }
  }

  #grow(slot: number): void {
    const room = VELOCITY * 2 ** Math.ceil(Math.log2(slot + 2));
    const { changes } = this.#step;
    const before = this.#before;
    this.#before = new Float64Array(room);
    this.#before.set(before);
    this.#step.changes = new Float64Array(room);
    this.#step.changes.set(changes);
  }

  // ---- at a contact point -----------------------------------------------------------------------------------------

  /** For every contact point of every step: no allocation here. */
  override contact(pointer: number, a: number, b: number): true {
    const pair = this.#pairOf(a, b);
    if (pair) this.#write(pointer, pair, a, b);
    return true;
  }

  #write(pointer: number, pair: Pair, a: number, b: number): void {
    const point = this.#at(pointer, a, b);
    const said = this.#overrides?.at(point, pair);
    const parameters = said === undefined ? this.#parametersAt(point, pair) : said;
    if (!parameters) {
      leaveOut(point);
      return;
    }
    writeSurface(point, pair, parameters, this.#step);
    this.listener?.note(point, pair, parameters);
    if (point.solverDistance >= FAR) return;
    const gently = parameters.bounce > 0 && isJointedPair(pair);
    if (said !== undefined || isSpecial(parameters)) this.special.add(pointer);
    if (this.#step.maxCorrectionSpeed < Infinity || isSoft(parameters) || gently) {
      this.written.add(pointer);
      writeDepth(point, pair, parameters, this.#step);
    }
  }

  #at(pointer: number, a: number, b: number): ContactPoint {
    return (this.#point ??= new ContactPoint(this.#simulation.engine.ammo)).at(pointer, a, b);
  }

  #pairOf(a: number, b: number): Pair | undefined {
    let byB = this.#pairs.get(a);
    if (!byB) this.#pairs.set(a, (byB = new Map()));
    let pair = byB.get(b);
    if (!pair && (pair = this.#find(a, b))) byB.set(b, pair);
    if (pair && pair.summed !== this.#steps) pair.impulse.fill(0);
    return pair;
  }

  #find(pointerA: number, pointerB: number): Pair | undefined {
    const a = this.#simulation.bodyAt(pointerA);
    const b = this.#simulation.bodyAt(pointerB);
    if (!a || !b) return undefined;
    return {
      a,
      b,
      parameters: this.#common(a, b),
      byParts: new Map(),
      atA: a.slot * VELOCITY,
      atB: b.slot * VELOCITY,
      impulse: new Float64Array(3),
      summed: -1,
      deepest: undefined,
      carried: carriedBy(a, b) === a ? 1 : -1,
    };
  }

  /** The parameters of a pair of bodies; undefined where their collidables differ in them. */
  #common(a: Body, b: Body): Pair['parameters'] {
    const found = new Set<ContactParameters | null>();
    for (const { collidable: first } of a.parts)
      for (const { collidable: second } of b.parts) found.add(this.#between(a, first, b, second));
    if (found.size > 1) return undefined;
    return found.size === 0 ? PLAIN : [...found][0];
  }

  /** Null: their contacts wait for set_contacts. */
  #between(a: Body, first: Collidable, b: Body, second: Collidable): ContactParameters | null {
    const { pairs } = this.#simulation;
    if (!pairs.collide(a, first, b, second)) return null;
    return pairs.between(first, second)?.parameters ?? PLAIN;
  }

  #parametersAt(point: ContactPoint, pair: Pair): ContactParameters | null {
    if (pair.parameters !== undefined) return pair.parameters;
    const parts = partsAt(point, pair.a, pair.b);
    let found = pair.byParts.get(parts);
    if (found === undefined) pair.byParts.set(parts, (found = this.#ofParts(point, pair)));
    return found;
  }

  #ofParts(point: ContactPoint, { a, b }: Pair): ContactParameters | null {
    const first = partAt(point, a, 0);
    const second = partAt(point, b, 1);
    return first && second ? this.#between(a, first, b, second) : PLAIN;
  }
}
