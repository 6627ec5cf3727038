import {
  add,
  conjugate,
  cross,
  dot,
  length,
  multiply,
  rotate,
  scale,
  subtract,
} from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { turnOf, type Carried } from './carried.js';
import { rub, type Rub } from './rub.js';
import { flat, type StepWay } from './smooth-way.js';

/** Numbers of a velocity: linear, then angular. */
const VELOCITY = 6;

/** What moves no faster than that against what carries it goes along with it, m/s: a contact solver leaves as much. */
export const ALONG = 0.02;

const NONE: Vec3 = [0, 0, 0];

/** How a body lies on the face of another in a step. */
export interface Grip {
  /** What it lies on, by pointer. */
  on: number;
  /** Into the body. */
  normal: Vec3;
  friction: number;
  /** Where all but contacts would take it, from rest; undefined: nobody knows. */
  pull: StepWay | undefined;
  /** Its velocity as the step began, m/s. */
  from: Vec3;
}

/** How a step left what it put somewhere: what goes along has the velocity of the whole step, what slips that of its end. */
interface Ride {
  on: Carried;
  sticks: boolean;
  /** It slips with the velocities of the middles of steps, as what hangs on springs of page code does. */
  leaps?: boolean;
  /** m/s, in double precision. */
  velocity: Vec3;
}

/** What stands on carried bodies, or on what stands there, and goes along with them in a step or slips. */
export class Riders {
  readonly #simulation: Simulation;
  /** Bodies that touch in the step, two pointers each. */
  readonly #pairs: number[] = [];
  readonly #grips = new Map<Body, Grip>();
  #rides = new Map<Body, Ride>();
  #before = new Map<Body, Ride>();
  readonly #velocity = new Float64Array(VELOCITY);
  readonly #pose = new Float64Array(POSE);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  begin(): void {
    this.#pairs.length = 0;
    this.#grips.clear();
    [this.#rides, this.#before] = [this.#before, this.#rides];
    this.#rides.clear();
  }

  forget(body: Body): void {
    this.#rides.delete(body);
    this.#before.delete(body);
  }

  note(a: number, b: number): void {
    const last = this.#pairs.length - 1;
    // The points of a pair come one after the other.
    if (last > 0 && this.#pairs[last - 1] === a && this.#pairs[last] === b) return;
    this.#pairs.push(a, b);
  }

  grip(body: Body, grip: Grip): void {
    this.#grips.set(body, grip);
  }

  has(body: Body): boolean {
    return this.#rides.has(body);
  }

  /** Bullet has moved them: what goes along is taken on the round way of what carries it. */
  take(all: ReadonlyMap<Body, Carried>, dt: number): void {
    this.#rub(all, dt);
    const pairs = this.#pairs;
    for (let found = true; found;) {
      found = false;
      for (let i = 0; i < pairs.length; i += 2) {
        const [a, b] = [this.#bodyAt(i), this.#bodyAt(i + 1)];
        if (!a || !b) continue;
        found = this.#goesOn(a, b, all, dt) || this.#goesOn(b, a, all, dt) || found;
      }
    }
  }

  #bodyAt(i: number): Body | undefined {
    return this.#simulation.bodyAt(this.#pairs[i]!);
  }

  // ---- by friction alone ------------------------------------------------------------------------------------------

  #rub(all: ReadonlyMap<Body, Carried>, dt: number): void {
    for (const [body, grip] of this.#grips) {
      const carried = all.get(this.#simulation.bodyAt(grip.on)!);
      if (carried && !carried.jumped) this.#rubBy(body, carried, grip, dt);
    }
  }

  #rubBy(body: Body, on: Carried, grip: Grip, dt: number): void {
    const { way } = on;
    if (!way || !lies(grip, way)) return;
    const by = this.#rubOf(body, grip, way, dt);
    if (by && !this.#before.get(body)?.leaps && isGentle(by, dt))
      this.#slide(body, on, way, by, grip, dt);
    else this.#leap(body, on, grip.normal, dt);
  }

  #rubOf(body: Body, grip: Grip, way: StepWay, dt: number): Rub | undefined {
    const { normal, friction, pull } = grip;
    if (!pull) return undefined;
    const weight = this.#weightOf(body, grip, way, pull, dt);
    return { normal, pull, grip: friction * Math.max(0, weight) };
  }

  /** It sticks and slips when it should within the step. */
  #slide(body: Body, on: Carried, way: StepWay, by: Rub, grip: Grip, dt: number): void {
    const { now, next, seconds } = on;
    const { normal } = by;
    const before = this.#before.get(body);
    const rode = before?.on === on && before.sticks;
    let from = exactly(grip, before);
    // What goes along has the velocity of the whole step, which is that of its middle.
    if (rode) {
      const ahead = flat(subtract(way.velocity(0), before.velocity), normal);
      from = add(from, within(ahead, (by.grip * seconds) / 2));
    }
    const { moved, speed, sticks } = rub(way, from, by, dt);
    // Moves of several steps go straight, what slips does not.
    const start = rode ? subtract(way.place(0), now.p) : NONE;
    const end = sticks ? subtract(next.p, way.place(dt)) : NONE;
    const to = flat(add(moved, add(start, end)), normal);
    const along = flat(sticks ? scale(subtract(next.p, now.p), 1 / dt) : speed, normal);
    this.#rides.set(body, { on, sticks, velocity: this.#put(body, normal, to, along, dt) });
  }

  /**
   * By what it is pressed on, m/s². What contacts push in a single step has in it what they need to stay in touch, which the
   * next one takes back: that counts only where it comes to lie.
   */
  #weightOf(body: Body, { normal, from }: Grip, way: StepWay, pull: StepWay, dt: number): number {
    const sped = this.#before.has(body)
      ? subtract(way.velocity(dt), way.velocity(0))
      : subtract(this.#velocityOf(body), from);
    const pulled = subtract(pull.velocity(dt), pull.velocity(0));
    return dot(subtract(sped, pulled), normal) / dt;
  }

  /** From middle to middle of steps, until it rides again: what had the velocity of an end gains half as much first. */
  #leap(body: Body, on: Carried, normal: Vec3, dt: number): void {
    const before = this.#before.get(body);
    let velocity = this.#velocityOf(body);
    if (before && !before.sticks && !before.leaps) {
      const mean = flat(scale(add(before.velocity, velocity), 1 / 2), normal);
      velocity = this.#put(body, normal, scale(mean, dt), mean, dt);
    }
    const [x, y, z] = on.velocity;
    if (length(subtract(velocity, [x!, y!, z!])) > ALONG)
      this.#rides.set(body, { on, sticks: false, leaps: true, velocity });
  }

  /** Along a surface, so far and with such a speed instead of Bullet's. Returns its velocity. */
  #put(body: Body, normal: Vec3, to: Vec3, along: Vec3, dt: number): Vec3 {
    const { reader, velocities } = this.#simulation.engine;
    const v = this.#velocityOf(body);
    const bullets = flat(v, normal);
    const velocity = add(subtract(v, bullets), along);
    this.#velocity.set(velocity);
    velocities.write(body.body, body.pointer, this.#velocity, 0);
    reader.shift(body.body, body.pointer, ...subtract(to, scale(bullets, dt)));
    return velocity;
  }

  #velocityOf({ body, pointer }: Body): Vec3 {
    this.#simulation.engine.reader.velocity(body, pointer, this.#velocity, 0);
    return [this.#velocity[0]!, this.#velocity[1]!, this.#velocity[2]!];
  }

  // ---- whatever holds it ------------------------------------------------------------------------------------------

  /** Whether a body is found to ride on another. */
  #goesOn(body: Body, on: Body, all: ReadonlyMap<Body, Carried>, dt: number): boolean {
    const carried = all.get(on) ?? this.#carrierOf(on);
    if (!carried || carried.jumped || !body.isDynamic || this.has(body)) return false;
    return this.#goesAlong(body, carried, dt);
  }

  #carrierOf(body: Body): Carried | undefined {
    const ride = this.#rides.get(body);
    return ride?.sticks ? ride.on : undefined;
  }

  #goesAlong(body: Body, carried: Carried, dt: number): boolean {
    const { reader } = this.#simulation.engine;
    const { now, next } = carried;
    const velocity = this.#velocityOf(body);
    reader.pose(body.body, body.pointer, this.#pose, 0);
    const end: Vec3 = [this.#pose[0]!, this.#pose[1]!, this.#pose[2]!];
    // Where it was when the step began, from what carries it.
    const from = subtract(subtract(end, scale(velocity, dt)), now.p);
    const turn = turnOf(now, next);
    const straight = add(subtract(next.p, now.p), cross(turn, from));
    if (length(subtract(scale(velocity, dt), straight)) > ALONG * dt) return false;
    this.#rides.set(body, { on: carried, sticks: true, velocity: scale(straight, 1 / dt) });
    const to = add(
      subtract(next.p, now.p),
      subtract(rotate(multiply(next.q, conjugate(now.q)), from), from),
    );
    const [x, y, z] = subtract(to, straight);
    if (x !== 0 || y !== 0 || z !== 0) reader.shift(body.body, body.pointer, x, y, z);
    return true;
  }
}

/** It neither comes nor goes. */
const lies = ({ from, normal }: Grip, way: StepWay): boolean =>
  Math.abs(dot(subtract(from, way.velocity(0)), normal)) < ALONG;

/** What pulls it changes in a step by no more than friction gives. */
const isGentle = ({ pull, grip }: Rub, dt: number): boolean =>
  length(subtract(pull.acceleration(dt), pull.acceleration(0))) <= grip;

/** No longer than so. */
function within(v: Vec3, most: number): Vec3 {
  const size = length(v);
  return size > most ? scale(v, most / size) : v;
}

/** Its velocity as the step began: single precision alone took something from it. */
const exactly = ({ from }: Grip, before: Ride | undefined): Vec3 =>
  before?.velocity.every((v, i) => Math.fround(v) === from[i]) ? before.velocity : from;
