import type { Body } from '../../dynamics/body.js';
import { MET, type Obstacles } from './collide/obstacles.js';
import type { Drift } from './drift.js';
import { Lying } from './lying.js';
import { Meeting } from './meeting.js';
import { clear, copy, Moving } from './moving.js';
import type { Pushed } from './pushed.js';
import { Reaction } from './reaction.js';
import type { Surface } from './surface.js';
import { Touch } from './touch.js';

/** Times that a particle is met in a step, at most: in a wedge it is met without end. What is left of the step it waits. */
const MOST_MET = 8;

/** Where a particle goes on that meets bodies on its way. */
export class Bounces {
  readonly #obstacles: Obstacles;
  readonly #pushed: Pushed;
  readonly #moving = new Moving();
  readonly #meeting: Meeting;
  readonly #touch: Touch;
  readonly #lying: Lying;
  readonly #reaction: Reaction;
  /**
   * Ways are searched straight, and go along arcs. Metres: how far above the surface its arc was when the straight way met
   * that, and how far its arc went along the surface beyond that; it makes good for this in the rest of the step.
   */
  #above = 0;
  readonly #beyond = new Float64Array(3);

  constructor(obstacles: Obstacles, pushed: Pushed) {
    this.#obstacles = obstacles;
    this.#pushed = pushed;
    this.#meeting = new Meeting(obstacles);
    const { met } = this.#meeting;
    const touch = new Touch(this.#moving, met);
    const lying = new Lying(this.#moving, touch, met, pushed);
    this.#touch = touch;
    this.#lying = lying;
    this.#reaction = new Reaction(this.#moving, touch, lying, met, obstacles, pushed);
  }

  /** False: nothing is in its way through the time that `drift` is for. */
  isNear(
    motion: Float64Array,
    at: number,
    push: Float64Array,
    drift: Drift,
    { bodies, walls, radius }: Surface,
  ): boolean {
    if (walls || !bodies) return true;
    const { from, to } = this.#moving.lookAhead(motion, at, push, drift);
    return this.#obstacles.isNear(from, to, radius);
  }

  /** What it would meet is what it met a step ago. */
  isCalm(
    motion: Float64Array,
    at: number,
    push: Float64Array,
    drift: Drift,
    { bodies, radius }: Surface,
  ): boolean {
    if (!bodies) return true;
    const { from, to } = this.#moving.lookAhead(motion, at, push, drift);
    return this.#obstacles.isCalm(from, to, radius);
  }

  /**
   * Moves a particle through the rest of a step of `dt` seconds, from the share `since` of it on; `motion` holds its place and
   * its velocity from `at` on, `push` what accelerates it. Returns whether that left it as it was.
   */
  follow(
    motion: Float64Array,
    at: number,
    push: Float64Array,
    damping: number,
    surface: Surface,
    dt: number,
    since: number,
  ): boolean {
    const moving = this.#moving;
    moving.read(motion, at, push, damping);
    this.#lying.end();
    clear(this.#beyond);
    let start = since;
    for (let tries = 0; this.#isStopped(surface, start, dt); tries++) {
      start = this.#meeting.met[MET.time]!;
      moving.free(push);
      this.#lying.end();
      const rest = (1 - start) * dt;
      if (tries === MOST_MET) {
        this.#wait(surface.mass, rest);
        break;
      }
      this.#turn(surface, dt, rest);
    }
    return moving.write(motion, at);
  }

  /** A body that throws a particle from a place, at a share of the step, is pushed the other way. */
  recoil(
    { slot }: Body,
    place: Float64Array,
    thrown: Float64Array,
    mass: number,
    share: number,
  ): void {
    if (mass === 0) return;
    const { met } = this.#meeting;
    met[MET.body] = slot;
    met[MET.time] = share;
    for (let i = 0; i < 3; i++) met[MET.point + i] = place[i]!;
    this.#pushed.push(met, thrown, 0, -mass);
  }

  /** Goes on to the end of the step from the share `start` of it, or to where something is in its way: then TRUE. */
  #isStopped(surface: Surface, start: number, dt: number): boolean {
    const moving = this.#moving;
    const rest = (1 - start) * dt;
    moving.lead(rest);
    const isMet = this.#meeting.meets(moving, surface, start);
    if (isMet) this.#stop((this.#meeting.met[MET.time]! - start) * dt, rest);
    else copy(moving.to, moving.from);
    moving.speed();
    this.#lying.press(surface.mass);
    return isMet;
  }

  /** Puts it where it was met, so many seconds later, on its way for the `rest` of the step. */
  #stop(seconds: number, rest: number): void {
    const { met } = this.#meeting;
    const moving = this.#moving;
    const { from, to } = moving;
    const share = rest > 0 ? seconds / rest : 0;
    const beyond = this.#beyond;
    for (let i = 0; i < 3; i++) {
      const straight = from[i]! + (to[i]! - from[i]!) * share;
      beyond[i] = beyond[i]! * (1 - share) - straight;
    }
    moving.lead(seconds);
    let above = 0;
    for (let i = 0; i < 3; i++) {
      beyond[i] = beyond[i]! + to[i]!;
      above += beyond[i]! * met[MET.normal + i]!;
      from[i] = met[MET.place + i]!;
    }
    for (let i = 0; i < 3; i++) beyond[i] = beyond[i]! - above * met[MET.normal + i]!;
    this.#above = above;
  }

  /** Where it was met it takes another way for the `rest` of the step, seconds. */
  #turn(surface: Surface, dt: number, rest: number): void {
    const moving = this.#moving;
    if (this.#meeting.isWall) this.#reaction.reflect(this.#above);
    else this.#reaction.react(surface, dt, moving.take(rest), this.#above);
    const { lift } = moving;
    if (rest > 0) for (let i = 0; i < 3; i++) lift[i] = lift[i]! + this.#beyond[i]! / rest;
  }

  /** Where it is held, to the end of the step: what holds it bears what would take it in. */
  #wait(mass: number, rest: number): void {
    if (this.#meeting.isWall) return;
    const { met } = this.#meeting;
    const pull = this.#touch.pull();
    if (mass > 0 && pull < 0) this.#pushed.push(met, met, MET.normal, mass * pull * rest);
    this.#obstacles.ride(met, this.#moving.from);
  }
}
