import type { Pose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Effect, type Cause, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { jointSolve } from '../joints/effects.js';
import { wakeTouching } from '../rest/touching.js';
import { Carried, type KeptMove } from './carried.js';
import { Riders, type KeptRide } from './riders.js';
import type { Grip } from './slips.js';

interface KeptCarrying {
  moves: [id: number, move: KeptMove][];
  rides: KeptRide[];
}

/** Seconds without a new pose after which a carried body stands still. */
const STILL = 0.1;

/**
 * Fixed bodies that are moved along (a ROUTE, an animated Transform above, a listener of each step): kinematic for Bullet
 * while they move, so that they push and drag what they touch. What its author tells before a step is where the body
 * stands at the end of it: during the step it goes there from where it was, at the speed of the whole move, and takes
 * along what joints hold. An animation moves it once per frame, which is several steps. A jump is no motion: the body is
 * there at once. At rest they are static again, since nothing may sleep on a kinematic body.
 */
export class Carrying extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #carried = new Map<Body, Carried>();
  readonly #riders: Riders;
  /** Whether Bullet was told in this step how fast they are. */
  #told = false;

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#riders = new Riders(simulation);
  }

  /** It is about to be elsewhere. Poses of the centre of mass: where it stands, and where it is to be. */
  carry(body: Body, from: Pose, to: Pose): void {
    const { time, timeStep, stepping } = this.#simulation;
    let carried = this.#carried.get(body);
    if (!carried) this.#carried.set(body, (carried = new Carried(from)));
    // Position and orientation come one after the other: by then all that it touches is awake.
    if (carried.since !== time) wakeTouching(this.#simulation, this.#effects, body);
    body.goAlong();
    carried.tell(to, time, stepping.turn, timeStep);
    this.need(body, 'position');
  }

  override reset(): void {
    this.#riders.reset();
    for (const body of [...this.#carried.keys()]) this.release(body);
  }

  override save(): KeptCarrying | undefined {
    if (!this.active) return undefined;
    const all = [...this.#carried];
    const idOf = (on: Carried): number => all.find(([, carried]) => carried === on)?.[0].id ?? 0;
    return {
      moves: all.map(([{ id }, carried]) => [id, carried.save()]),
      rides: this.#riders.save(idOf),
    };
  }

  override load({ moves, rides }: KeptCarrying, nodes: Numbered): void {
    for (const [id, move] of moves) {
      const body = nodes.body(id);
      if (!body || body.movable) continue;
      body.goAlong();
      this.#carried.set(body, Carried.from(move));
      this.need(body, 'position');
    }
    for (const [id, onId, ride] of rides) {
      const body = nodes.body(id);
      const on = this.#carried.get(nodes.body(onId)!);
      if (body && on) this.#riders.load(body, { ...structuredClone(ride), on });
    }
  }

  override release(node: Cause): void {
    super.release(node);
    const carried = this.#carried.get(node as Body);
    if (!carried) return;
    this.#carried.delete(node as Body);
    this.#effects.find(jointSolve)?.stands(node as Body);
  }

  override unmade(node: Cause): void {
    this.#riders.forget(node as Body);
    this.release(node);
  }

  /** By what a body that touches nothing else is held and rubbed in this step. */
  grips(body: Body, grip: Grip): void {
    this.#riders.grip(body, grip);
  }

  /** Whether a body that stands or slips on what is carried was put where it is after the step. */
  carries(body: Body): boolean {
    return this.active && this.#riders.has(body);
  }

  /** Between steps it is where it was told to be; in the step it sets out from where it was. */
  override beforeStep(dt: number): void {
    const { scratch } = this.#simulation.engine;
    this.#riders.begin();
    this.#told = false;
    for (const [body, carried] of this.#carried) {
      const before = carried.begin(this.#simulation.time, dt);
      if (carried.jumped) {
        if (before) body.body.setInterpolationWorldTransform(scratch.transform(before.p, before.q));
        continue;
      }
      this.#put(body, carried.now);
      // Bullet takes the velocity of a kinematic body from how far its pose is from the interpolation pose.
      body.body.setInterpolationWorldTransform(scratch.transform(before!.p, before!.q));
      this.#effects.find(jointSolve)?.carry(body, carried);
    }
  }

  override contact(_: number, a: number, b: number): boolean {
    if (!this.#told) this.#tellVelocities();
    this.#riders.note(a, b);
    return true;
  }

  /** Bullet's own, from two poses in single precision, are rough: 6 % off at 1 rad/s and 1/960 s. */
  #tellVelocities(): void {
    this.#told = true;
    const { velocities } = this.#simulation.engine;
    for (const [{ pointer }, { jumped, velocity }] of this.#carried)
      if (!jumped) velocities.write(pointer, velocity, 0);
  }

  override settle(dt: number): void {
    this.#riders.take(this.#carried, dt);
    for (const [body, carried] of this.#carried) {
      if (carried.jumped) continue;
      this.#put(body, carried.next);
      carried.end(dt);
    }
  }

  #put(body: Body, { p, q }: Pose): void {
    body.body.setCenterOfMassTransform(this.#simulation.engine.scratch.transform(p, q));
  }

  override afterStep(): void {
    for (const [body, { since }] of this.#carried) {
      if (this.#simulation.time - since < STILL) continue;
      this.release(body);
      body.standStill();
    }
  }
}
