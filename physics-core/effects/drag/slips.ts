import { add, dot, length, scale, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import type { Carried } from './carried.js';
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
export interface Ride {
  on: Carried;
  sticks: boolean;
  /** It slips with the velocities of the middles of steps, as what hangs on springs of page code does. */
  leaps?: boolean;
  /** m/s, in double precision. */
  velocity: Vec3;
}

/** One that lies on a carried body in a step of `dt` seconds. */
export interface Lying {
  body: Body;
  on: Carried;
  grip: Grip;
  /** How the last step left it. */
  before: Ride | undefined;
  dt: number;
}

/** What lies on a carried body by friction alone: it sticks and slips when it should within a step. */
export class Slips {
  readonly #simulation: Simulation;
  readonly #velocity = new Float64Array(VELOCITY);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  /** Undefined: friction has nothing to do with it. */
  take(lying: Lying): Ride | undefined {
    const { on, grip, before, dt } = lying;
    const { way } = on;
    if (!way || !lies(grip, way)) return undefined;
    const by = grip.pull && this.#rubOf(lying, way, grip.pull);
    const gently = by && !before?.leaps && isGentle(by, dt);
    return gently ? this.#slide(lying, way, by) : this.#leap(lying);
  }

  #rubOf(lying: Lying, way: StepWay, pull: StepWay): Rub {
    const { normal, friction } = lying.grip;
    const grip = friction * Math.max(0, this.#weightOf(lying, way, pull));
    return { normal, pull, grip };
  }

  /** It sticks and slips when it should within the step. */
  #slide({ body, on, grip, before, dt }: Lying, way: StepWay, by: Rub): Ride {
    const { now, next, seconds } = on;
    const { normal } = by;
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
    return { on, sticks, velocity: this.#put(body, normal, to, along, dt) };
  }

  /**
   * By what it is pressed on, m/s². What contacts push in a single step has in it what they need to stay in touch, which the
   * next one takes back: that counts only where it comes to lie.
   */
  #weightOf({ body, grip, before, dt }: Lying, way: StepWay, pull: StepWay): number {
    const sped = before
      ? subtract(way.velocity(dt), way.velocity(0))
      : subtract(this.velocityOf(body), grip.from);
    const pulled = subtract(pull.velocity(dt), pull.velocity(0));
    return dot(subtract(sped, pulled), grip.normal) / dt;
  }

  /** From middle to middle of steps, until it rides again: what had the velocity of an end gains half as much first. */
  #leap({ body, on, grip: { normal }, before, dt }: Lying): Ride | undefined {
    let velocity = this.velocityOf(body);
    if (before && !before.sticks && !before.leaps) {
      const mean = flat(scale(add(before.velocity, velocity), 1 / 2), normal);
      velocity = this.#put(body, normal, scale(mean, dt), mean, dt);
    }
    const [x, y, z] = on.velocity;
    const slips = length(subtract(velocity, [x!, y!, z!])) > ALONG;
    return slips ? { on, sticks: false, leaps: true, velocity } : undefined;
  }

  /** Along a surface, so far and with such a speed instead of Bullet's. Returns its velocity. */
  #put(body: Body, normal: Vec3, to: Vec3, along: Vec3, dt: number): Vec3 {
    const { reader, velocities } = this.#simulation.engine;
    const v = this.velocityOf(body);
    const bullets = flat(v, normal);
    const velocity = add(subtract(v, bullets), along);
    this.#velocity.set(velocity);
    velocities.write(body.pointer, this.#velocity, 0);
    reader.shift(body.pointer, ...subtract(to, scale(bullets, dt)));
    return velocity;
  }

  /** Its linear velocity, m/s. */
  velocityOf({ pointer }: Body): Vec3 {
    this.#simulation.engine.reader.velocity(pointer, this.#velocity, 0);
    return [this.#velocity[0]!, this.#velocity[1]!, this.#velocity[2]!];
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
