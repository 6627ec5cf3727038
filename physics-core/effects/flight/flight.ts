import { log } from '../../base/exact/index.js';
import type { Vec3 } from '../../fields/types.js';
import { add, scale } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { turnsAlike } from '../../dynamics/moments.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { carrying } from '../drag/effects.js';
import { dragging } from '../drag/dragging.js';
import { EVEN, FreeFall, MOTION, RESTING, same } from '../../engine/free-fall.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { Effect, type Cause, type EffectDescriptor, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { impactPropagation } from '../hits/effects.js';
import { jointSolve } from '../joints/effects.js';
import { forces } from './forces.js';
import { gyroscopic } from './gyroscopic.js';
import { dot3, multiply4, writeTurn } from '../../base/flat-math.js';

/** How contacts that it turns about turn a body in a step. */
export interface Turning {
  /** To where, with these six numbers; undefined: evenly by what they gave it. */
  to(body: Body, velocity: Float64Array, dt: number): Float64Array | undefined;
  /**
   * It began to turn just now. What rests is moved by what it has at the end of each step, and so is ahead by half a step
   * of its speed: that much is taken back.
   */
  readonly begins: boolean;
}

/** A body that something known pulls or turns: linear parts, then angular ones. */
interface Flyer {
  body: Body;
  /** m/s² and rad/s², world frame. */
  acceleration: Float64Array;
  /** Newtons and newton metres that its author gave. */
  load: Vec3;
  turns: boolean;
  /** Its forces are others than in the step before. */
  varies: boolean;
}

/**
 * Bullet moves a body by the velocity it has at the end of a step, which makes every throw ½ g t dt too long. What
 * nothing touched in a step is put where gravity, its author's forces and damping take it in that time: that is known
 * exactly, at every level. A body that anything else acted on shows it by its velocity and is left as it is; so is one
 * whose forces change from step to step, as those of springs made by page code do: they would gain energy.
 */
export class Flight extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  /** By slot. */
  readonly #flyers: (Flyer | undefined)[] = [];
  readonly #fall = new FreeFall();
  /** Those whose forces are others than in the step before. */
  readonly #varying: Flyer[] = [];
  /** Those that turn about a corner in this step. */
  readonly #turning = new Map<Body, Turning>();
  readonly #now = new Float64Array(VELOCITY);
  /** What is to be added to the place and the orientation, and whether velocities are others than Bullet's. */
  readonly #displacement = new Float64Array(VELOCITY);
  #faster = false;
  readonly #pose = new Float64Array(POSE);
  readonly #turn = new Float64Array(4);
  readonly #rotation = new Float64Array(3);

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
  }

  /** Its gravity, forces, damping, mass or mobility may be others. */
  override need(body: Body, reason: string): void {
    const before = this.#flyers[body.slot];
    const { force } = body.constantLoad;
    const acceleration = accelerationOf(body);
    const turns = isTurned(body, acceleration);
    const varies = before !== undefined && (before.varies || other(before.load, force));
    const flyer = { body, acceleration, load: force, turns, varies };
    this.#flyers[body.slot] = flyer;
    if (varies) this.#varying.push(flyer);
    this.#fall.set(body.slot, motionOf(flyer), acceleration);
    super.need(body, reason);
  }

  override release(node: Cause): void {
    super.release(node);
    const { slot } = node as Body;
    if (this.#flyers[slot]?.body !== node) return;
    this.#flyers[slot] = undefined;
    this.#fall.set(slot, MOTION.unknown);
  }

  override reset(): void {
    this.#turning.clear();
    this.#steady();
  }

  override save(): number[] | undefined {
    return this.#varying.length > 0 ? this.#varying.map(({ body }) => body.id) : undefined;
  }

  override load(saved: readonly number[], nodes: Numbered): void {
    for (const id of saved) {
      const body = nodes.body(id);
      if (body) this.vary(body);
    }
  }

  /** Its forces are others in this step than in the one before: it is left as it is. */
  vary({ slot }: Body): void {
    const flyer = this.#flyers[slot];
    if (!flyer) return;
    flyer.varies = true;
    this.#varying.push(flyer);
    this.#fall.set(slot, motionOf(flyer));
  }

  /** Whether nothing acts on it in this step but what is known and, evenly, what touches it. */
  glides(body: Body): boolean {
    return (
      this.isPushed(body) &&
      !this.#flyers[body.slot]!.varies &&
      !this.#effects.caused(carrying)?.carries(body) &&
      !this.#effects.find(forces)?.pending(body)
    );
  }

  /** The same, with whatever page code does. */
  isPushed(body: Body): boolean {
    return (
      this.#flyers[body.slot]?.body === body &&
      !this.#effects.caused(jointSolve)?.lastStep(body) &&
      !(this.#hits && this.#effects.find(impactPropagation)?.struck(body)) &&
      !this.#effects.caused(dragging)?.isNeededBy(body)
    );
  }

  /** Whether all do that only fall: nobody is here that acts on single ones. */
  #allGlide(): boolean {
    const effects = this.#effects;
    return (
      !effects.caused(jointSolve) &&
      !this.#hits &&
      !effects.caused(carrying) &&
      !effects.caused(forces) &&
      !effects.caused(dragging)
    );
  }

  /** Whether anything may be hit in this step. */
  get #hits(): boolean {
    return this.#effects.active(impactPropagation);
  }

  /** It turns about a corner in this step: that goes on evenly, too, however slow it is. */
  turnsOn(body: Body, turning: Turning): void {
    this.#turning.set(body, turning);
  }

  override settle(dt: number): void {
    const { engine, bodies } = this.#simulation;
    const joints = this.#effects.caused(jointSolve);
    const fall = this.#fall;
    joints?.eachMoved(this.#standAside);
    for (const body of this.#turning.keys()) this.#standAside(body);
    fall.all(engine.ammo, bodies.moving, dt, this.#allGlide());
    for (let i = 0; i < fall.asideCount; i++) {
      const flyer = this.#flyers[fall.aside[i]!]!;
      // The joint solve keeps its velocity in the middle of each step, which is exact enough.
      if (!flyer.varies && !joints?.lastStep(flyer.body)) this.#fly(flyer, dt);
    }
    joints?.eachMoved(this.#comeBack);
    for (const body of this.#turning.keys()) this.#comeBack(body);
    this.#turning.clear();
    if (this.#varying.length > 0) this.#steady();
  }

  readonly #standAside = ({ slot }: Body): void => {
    if (this.#flyers[slot]) this.#fall.set(slot, MOTION.other);
  };

  readonly #comeBack = ({ slot }: Body): void => {
    const flyer = this.#flyers[slot];
    if (flyer) this.#fall.set(slot, motionOf(flyer));
  };

  /** Forces are those of the step before. */
  #steady(): void {
    for (const flyer of this.#varying) {
      flyer.varies = false;
      if (this.#flyers[flyer.body.slot] === flyer) this.#fall.set(flyer.body.slot, motionOf(flyer));
    }
    this.#varying.length = 0;
  }

  #fly(flyer: Flyer, dt: number): void {
    const { body, acceleration, turns } = flyer;
    const { linear, angular } = body.dampedShare;
    this.#simulation.engine.reader.velocity(body.pointer, this.#now, 0);
    if (!turns && linear === 0) {
      this.#drop(flyer, dt);
      return;
    }
    this.#displacement.fill(0);
    this.#faster = false;
    const flies =
      this.#lead(0, body.slot, acceleration, linear, dt) || this.#glide(body, acceleration, dt);
    if (turns && this.#lead(3, body.slot, acceleration, angular, dt)) this.#place(body);
    else if (flies) this.#goOn(body, dt);
    if (this.#faster) this.#hasten(body);
  }

  #shift({ pointer }: Body, x: number, y: number, z: number): void {
    this.#simulation.engine.reader.shift(pointer, x, y, z);
  }

  /** What most do: the rest in one go, for its speed (measured: 35 ns instead of 110). */
  #drop({ body, acceleration }: Flyer, dt: number): void {
    const v = this.#simulation.bodies.velocities;
    const at = body.slot * VELOCITY;
    const x = acceleration[0]! * dt;
    const y = acceleration[1]! * dt;
    const z = acceleration[2]! * dt;
    const now = this.#now;
    const half = dt / 2;
    if (same(now[0]!, v[at]!, x) && same(now[1]!, v[at + 1]!, y) && same(now[2]!, v[at + 2]!, z))
      this.#shift(body, -x * half, -y * half, -z * half);
    else if (this.#glide(body, acceleration, dt)) this.#goOn(body, dt);
  }

  /** Three parts of a damped or turning motion, from `part` on. False: something else acted on them in this step. */
  #lead(part: 0 | 3, slot: number, acceleration: Float64Array, share: number, dt: number): boolean {
    const now = this.#now;
    const v = this.#simulation.bodies.velocities;
    const at = slot * VELOCITY;
    const left = (1 - share) ** dt;
    for (let i = part; i < part + 3; i++)
      if (!same(now[i]!, v[at + i]! * left, acceleration[i]! * dt)) return false;
    const rate = -log(1 - share);
    // Seconds that a velocity and its growth count for, damped meanwhile.
    const time = share > 0 ? (1 - left) / rate : dt;
    const growth = share > 0 ? (dt - time) / rate : (dt * dt) / 2;
    for (let i = part; i < part + 3; i++) {
      this.#displacement[i] = v[at + i]! * time + acceleration[i]! * growth - now[i]! * dt;
      if (share > 0) now[i] = v[at + i]! * left + acceleration[i]! * time;
    }
    this.#faster ||= share > 0;
    return true;
  }

  /**
   * What slides or rolls is pushed evenly over the step, and goes on with the mean of the speeds at its ends. A hit is
   * more than what acts by itself could be; its speed Bullet takes at once. What stands on a lift is where that is. What page code or a hand pulls may hang on a spring.
   */
  #glide(body: Body, acceleration: Float64Array, dt: number): boolean {
    const v = this.#simulation.bodies.velocities;
    const at = body.slot * VELOCITY;
    const turning = this.#turning.get(body);
    const rested = turning?.begins && dot3(v, at, v, at) < RESTING ** 2;
    let change = 0;
    let most = 0;
    let speed = 0;
    for (let i = 0; i < 3; i++) {
      const gained = this.#now[i]! - v[at + i]!;
      speed += this.#now[i]! ** 2;
      change += gained ** 2;
      most += (acceleration[i]! * dt) ** 2;
      this.#displacement[i] = (-dt / 2) * (rested ? this.#now[i]! : gained);
    }
    if (speed < RESTING ** 2 && !turning) return false;
    return change <= most * EVEN && this.glides(body);
  }

  /** By what was found, and turned as evenly where it turns about a corner. */
  #goOn(body: Body, dt: number): void {
    const displacement = this.#displacement;
    const turning = this.#turning.get(body);
    if (!turning) {
      this.#shift(body, displacement[0]!, displacement[1]!, displacement[2]!);
      return;
    }
    const given = this.#effects.caused(gyroscopic)?.given(body);
    const v = this.#simulation.bodies.velocities;
    const at = body.slot * VELOCITY + 3;
    for (let i = 0; i < 3; i++) {
      const before = turning.begins ? 0 : given ? given[i]! : v[at + i]!;
      displacement[3 + i] = (-dt / 2) * (this.#now[3 + i]! - before);
    }
    this.#place(body, turning.to(body, this.#now, dt));
  }

  /** With another orientation: `to`, or what is to be added to the one that it has. */
  #place({ body, pointer }: Body, to?: Float64Array): void {
    const { reader, scratch } = this.#simulation.engine;
    const pose = this.#pose;
    const turn = this.#turn;
    const rotation = this.#rotation;
    const displacement = this.#displacement;
    reader.pose(pointer, pose, 0);
    for (let i = 0; i < 3; i++) rotation[i] = displacement[3 + i]!;
    writeTurn(turn, rotation, 1);
    multiply4(turn, turn, 0, pose, 3);
    if (to) turn.set(to);
    body.setCenterOfMassTransform(
      scratch.transform(
        [pose[0]! + displacement[0]!, pose[1]! + displacement[1]!, pose[2]! + displacement[2]!],
        [turn[0]!, turn[1]!, turn[2]!, turn[3]!],
      ),
    );
  }

  #hasten({ body }: Body): void {
    const { scratch } = this.#simulation.engine;
    const now = this.#now;
    body.setLinearVelocity(scratch.vector(now[0]!, now[1]!, now[2]!));
    body.setAngularVelocity(scratch.vector(now[3]!, now[4]!, now[5]!));
  }
}

/** By gravity and its author's forces: m/s² and rad/s², linear then angular. */
function accelerationOf({ gravity, mass: { mass, moments }, constantLoad }: Body): Float64Array {
  const { force, torque } = constantLoad;
  return Float64Array.from([
    ...add(gravity, scale(force, 1 / mass)),
    ...(turnsAlike(moments) ? scale(torque, 1 / moments[0]) : [0, 0, 0]),
  ]);
}

/** What only falls is no work. */
const motionOf = ({ body: { dampedShare }, turns, varies }: Flyer): number =>
  turns || varies || dampedShare.linear > 0 ? MOTION.other : MOTION.falls;

const isTurned = ({ dampedShare }: Body, acceleration: Float64Array): boolean =>
  dampedShare.angular > 0 || acceleration.subarray(3).some(Boolean);

/** Whether something known pulls, turns or brakes it. What a torque does to unequal moments is not known in closed form. */
const isLed = ({ movable, gravity, mass, constantLoad, dampedShare }: Body): boolean =>
  movable &&
  (gravity.some(Boolean) ||
    constantLoad.force.some(Boolean) ||
    (constantLoad.torque.some(Boolean) && turnsAlike(mass.moments)) ||
    dampedShare.linear > 0 ||
    dampedShare.angular > 0);

/** Whether one force gave way to another: one that begins or ends is none that follows the motion. */
const other = (a: Vec3, b: Vec3): boolean =>
  a.some(Boolean) && b.some(Boolean) && a.some((x, i) => x !== b[i]);

export const flight: EffectDescriptor<Flight> = {
  name: 'free flight',
  after: { carrying: 'what stands on a carried body goes where that goes' },
  causes: 'a body that gravity, its author’s forces or damping move',
  body: {
    on: ['mass', 'gravity', 'load', 'damping'],
    reason: (body) => (isLed(body) ? 'gravity, forces or damping' : undefined),
  },
  load: (simulation, effects) => new Flight(simulation, effects),
};
