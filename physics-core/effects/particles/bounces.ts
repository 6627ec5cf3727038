import type { Body } from '../../dynamics/body.js';
import { METS, MET, type Obstacles } from './collide/obstacles.js';
import type { SheetSolid } from './collide/sheet.js';
import { FOUND, WAY } from './collide/solid.js';
import { Drift } from './drift.js';
import type { Pushed } from './pushed.js';

/** Times that a particle is met in a step, at most: in a wedge it is met without end. What is left of the step it waits. */
const MOST_MET = 8;

/** How particles of a system meet bodies and walls. */
export interface Surface {
  /** Whether they meet bodies, and the mass by which each pushes them, kg: 0 pushes nothing. */
  bodies: boolean;
  mass: number;
  /** What throws them back with the speed with which they came; undefined: nothing. */
  walls: SheetSolid | undefined;
  /** Of the balls that are met, metres. */
  radius: number;
  /** Share of the approach speed that comes back. */
  bounce: number;
  /** Coulomb's. */
  friction: number;
}

/** No time. */
const NOTHING = new Drift();

/** A few numbers: `set` takes ten times as long. */
function copy(from: Float64Array, to: Float64Array): void {
  for (let i = 0; i < to.length; i++) to[i] = from[i]!;
}

/** Where a particle goes on that meets bodies on its way. */
export class Bounces {
  readonly #obstacles: Obstacles;
  readonly #pushed: Pushed;
  readonly #drift = new Drift();
  readonly #met = new Float64Array(METS);
  readonly #way = new Float64Array(WAY);
  readonly #found = new Float64Array(FOUND);
  /** What was met is a wall. */
  #isWall = false;
  /** Of its drag, 1/s. */
  #damping = 0;
  readonly #from = new Float64Array(3);
  readonly #to = new Float64Array(3);
  /** m/s; of what was met, the same; and what pushes, m/s². */
  readonly #velocity = new Float64Array(3);
  readonly #surface = new Float64Array(3);
  readonly #borneBy = new Float64Array(3);
  readonly #push = new Float64Array(3);
  /** Along the surface. */
  readonly #along = new Float64Array(3);
  /** Beside its velocity, m/s: what bears it is where it is drawn, and has the speed that it was given in the next step only. */
  readonly #lift = new Float64Array(3);
  /** What bears it, as it was met, and how, m/s²: from below, and by friction the other way than `#braked`. */
  readonly #borne = new Float64Array(METS);
  readonly #braked = new Float64Array(3);
  #bearing = 0;
  #braking = 0;
  /**
   * Ways are searched straight, and go along arcs. Metres: how far above the surface its arc was when the straight way met
   * that, and how far its arc went along the surface beyond that; it makes good for this in the rest of the step.
   */
  #above = 0;
  readonly #beyond = new Float64Array(3);

  constructor(obstacles: Obstacles, pushed: Pushed) {
    this.#obstacles = obstacles;
    this.#pushed = pushed;
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
    this.#lookAhead(motion, at, push, drift);
    return this.#obstacles.isNear(this.#from, this.#to, radius);
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
    this.#lookAhead(motion, at, push, drift);
    return this.#obstacles.isCalm(this.#from, this.#to, radius);
  }

  #lookAhead(motion: Float64Array, at: number, push: Float64Array, drift: Drift): void {
    const { wayOfSpeed, wayOfPush } = drift;
    for (let i = 0; i < 3; i++) {
      const from = (this.#from[i] = motion[at + i]!);
      this.#to[i] = from + motion[at + 3 + i]! * wayOfSpeed + push[i]! * wayOfPush;
    }
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
    this.#damping = damping;
    this.#take(motion, at, push);
    let start = since;
    for (let tries = 0; this.#isStopped(surface, start, dt); tries++) {
      start = this.#met[MET.time]!;
      this.#free(push);
      const rest = (1 - start) * dt;
      if (tries === MOST_MET) {
        this.#wait(surface.mass, rest);
        break;
      }
      if (this.#isWall) this.#reflect();
      else this.#react(surface, dt, this.#drift.take(damping, rest));
      if (rest > 0)
        for (let i = 0; i < 3; i++) this.#lift[i] = this.#lift[i]! + this.#beyond[i]! / rest;
    }
    let still = true;
    for (let i = 0; i < 3; i++) {
      if (motion[at + i] !== this.#from[i] || motion[at + 3 + i] !== this.#velocity[i])
        still = false;
      motion[at + i] = this.#from[i]!;
      motion[at + 3 + i] = this.#velocity[i]!;
    }
    return still;
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
    const met = this.#met;
    met[MET.body] = slot;
    met[MET.time] = share;
    for (let i = 0; i < 3; i++) met[MET.point + i] = place[i]!;
    this.#pushed.push(met, thrown, 0, -mass);
  }

  #take(motion: Float64Array, at: number, push: Float64Array): void {
    for (let i = 0; i < 3; i++) {
      this.#from[i] = motion[at + i]!;
      this.#velocity[i] = motion[at + 3 + i]!;
    }
    this.#beyond.fill(0);
    this.#free(push);
  }

  /** Nothing bears it. */
  #free(push: Float64Array): void {
    copy(push, this.#push);
    for (let i = 0; i < 3; i++) this.#lift[i] = 0;
    this.#bearing = 0;
  }

  /** Goes on to the end of the step from the share `start` of it, or to where something is in its way: then TRUE. */
  #isStopped(surface: Surface, start: number, dt: number): boolean {
    const rest = (1 - start) * dt;
    this.#drift.take(this.#damping, rest);
    this.#lead(rest);
    const isMet = this.#meets(surface, start);
    if (isMet) this.#stop((this.#met[MET.time]! - start) * dt, rest);
    else copy(this.#to, this.#from);
    this.#speed();
    this.#press(surface.mass);
    return isMet;
  }

  /** Puts it where it was met, so many seconds later, on its way for the `rest` of the step. */
  #stop(seconds: number, rest: number): void {
    const met = this.#met;
    this.#makeUnit();
    const share = rest > 0 ? seconds / rest : 0;
    const beyond = this.#beyond;
    for (let i = 0; i < 3; i++) {
      const straight = this.#from[i]! + (this.#to[i]! - this.#from[i]!) * share;
      beyond[i] = beyond[i]! * (1 - share) - straight;
    }
    this.#drift.take(this.#damping, seconds);
    this.#lead(seconds);
    let above = 0;
    for (let i = 0; i < 3; i++) {
      beyond[i] = beyond[i]! + this.#to[i]!;
      above += beyond[i]! * met[MET.normal + i]!;
      this.#from[i] = met[MET.place + i]!;
    }
    for (let i = 0; i < 3; i++) beyond[i] = beyond[i]! - above * met[MET.normal + i]!;
    this.#above = above;
  }

  /** Where it is held, to the end of the step: what holds it bears what would take it in. */
  #wait(mass: number, rest: number): void {
    if (this.#isWall) return;
    const met = this.#met;
    const pull = this.#pull();
    if (mass > 0 && pull < 0) this.#pushed.push(met, met, MET.normal, mass * pull * rest);
    this.#obstacles.ride(met, this.#from);
  }

  /** Where it comes, if nothing is in its way. */
  #lead(seconds: number): void {
    const { wayOfSpeed, wayOfPush } = this.#drift;
    const lift = this.#lift;
    for (let i = 0; i < 3; i++)
      this.#to[i] =
        this.#from[i]! +
        this.#velocity[i]! * wayOfSpeed +
        this.#push[i]! * wayOfPush +
        lift[i]! * seconds;
  }

  /** What bore it so long was pressed and dragged by it. */
  #press(mass: number): void {
    if (this.#bearing === 0 || mass === 0) return;
    const borne = this.#borne;
    const seconds = this.#drift.speedOfPush;
    this.#pushed.push(borne, borne, MET.normal, -mass * this.#bearing * seconds);
    if (this.#braking > 0)
      this.#pushed.push(borne, this.#braked, 0, mass * this.#braking * seconds);
  }

  /** Whether something is in its way from the share `start` of the step on. */
  #meets({ bodies, walls, radius }: Surface, start: number): boolean {
    const met = this.#met;
    const isBody = bodies && this.#obstacles.meet(this.#from, this.#to, radius, met, start, 1);
    this.#isWall = !!walls && this.#meetsWall(walls, radius, start, isBody ? met[MET.share]! : 1);
    return isBody || this.#isWall;
  }

  /** The same for walls, before the share `most` of the way. */
  #meetsWall(walls: SheetSolid, radius: number, start: number, most: number): boolean {
    const way = this.#way;
    const found = this.#found;
    const from = this.#from;
    for (let i = 0; i < 3; i++) {
      way[i] = from[i]!;
      way[3 + i] = this.#to[i]! - from[i]!;
    }
    way[6] = radius;
    way[7] = most;
    if (!walls.meets(way, found)) return false;
    const met = this.#met;
    const share = found[0]!;
    const depth = found[1]!;
    met[MET.time] = start + (1 - start) * share;
    for (let i = 0; i < 3; i++) {
      const normal = found[2 + i]!;
      met[MET.normal + i] = normal;
      met[MET.place + i] = from[i]! + way[3 + i]! * share + normal * depth;
    }
    return true;
  }

  #reflect(): void {
    this.#surface.fill(0);
    const approach = this.#approach();
    if (approach >= 0) return;
    const change = this.#fallen(approach, this.#pull()) - 2 * approach;
    for (let i = 0; i < 3; i++)
      this.#velocity[i] = this.#velocity[i]! + change * this.#met[MET.normal + i]!;
  }

  /**
   * Ways are searched straight, and go along arcs: the speed that it would have gained on the last bit, m/s. Without it what
   * falls would rise less high than its bounce says, by a third of a millimetre at `game`.
   */
  #fallen(approach: number, pull: number): number {
    const square = approach * approach - 2 * (pull - this.#damping * this.#climb()) * this.#above;
    return square > 0 ? Math.sqrt(square) + approach : 0;
  }

  /** Poses that were read in single precision turn by a matrix that is a ten-millionth off: what lies would be met again. */
  #makeUnit(): void {
    const met = this.#met;
    let square = 0;
    for (let i = MET.normal; i < MET.normal + 3; i++) square += met[i]! ** 2;
    const length = Math.sqrt(square);
    for (let i = MET.normal; i < MET.normal + 3; i++) met[i] = met[i]! / length;
  }

  /** How fast it is then. */
  #speed(): void {
    const { left, speedOfPush } = this.#drift;
    const velocity = this.#velocity;
    for (let i = 0; i < 3; i++) velocity[i] = velocity[i]! * left + this.#push[i]! * speedOfPush;
  }

  /** What is along the normal, relative to the surface, m/s. */
  #approach(): number {
    const met = this.#met;
    let speed = 0;
    for (let i = 0; i < 3; i++)
      speed += (this.#velocity[i]! - this.#surface[i]!) * met[MET.normal + i]!;
    return speed;
  }

  /**
   * Newton's law of restitution, and Coulomb's of friction. What would be back within the step, `dt` seconds, does not leave
   * the surface: it bears it in the `rest` of the step.
   */
  #react({ bounce, friction, mass }: Surface, dt: number, rest: Drift): void {
    const met = this.#met;
    this.#obstacles.velocityAt(met, this.#surface);
    const drawn = this.#approach();
    if (mass > 0) this.#pushed.addNormalVelocity(met, this.#surface);
    const approach = this.#approach();
    const pull = this.#pull();
    const fallen = approach < 0 ? this.#fallen(approach, pull) : 0;
    const back = approach < 0 ? bounce * (fallen - approach) : approach;
    const stays = 2 * back <= -pull * dt;
    if (approach < 0) {
      const given = this.#give(met, MET.normal, (stays ? 0 : back) - approach, mass);
      this.#rub(friction * given, mass);
    }
    for (let i = 0; i < 3; i++) this.#lift[i] = (approach - drawn) * met[MET.normal + i]!;
    if (!stays || rest.speedOfPush === 0) return;
    const away = (Math.max(0, approach) * rest.left) / rest.speedOfPush;
    this.#bear(friction, away + pull, rest);
  }

  /**
   * Changes its speed along a direction, as seen from the body, by so much, m/s: both give way, each by its mass. Returns what
   * it has of that itself.
   */
  #give(direction: Float64Array, at: number, change: number, mass: number): number {
    const own =
      mass > 0 ? change / (1 + mass * this.#pushed.softness(this.#met, direction, at)) : change;
    for (let i = 0; i < 3; i++) this.#velocity[i] = this.#velocity[i]! + own * direction[at + i]!;
    if (mass > 0) this.#pushed.push(this.#met, direction, at, -mass * own);
    return own;
  }

  /** How fast it is along the normal, in the world, m/s: drag goes by that. */
  #climb(): number {
    let speed = 0;
    for (let i = 0; i < 3; i++) speed += this.#velocity[i]! * this.#met[MET.normal + i]!;
    return speed;
  }

  /** What pushes it along the normal, m/s². */
  #pull(): number {
    let pull = 0;
    for (let i = 0; i < 3; i++) pull += this.#push[i]! * this.#met[MET.normal + i]!;
    return pull;
  }

  /**
   * Brakes it along the surface by as much of its own speed, m/s, at most to a stand: that of a body which others that struck
   * it in this step have taken along.
   */
  #rub(most: number, mass: number): void {
    if (mass === 0) {
      this.#brake(most, 0);
      return;
    }
    const met = this.#met;
    const surface = this.#surface;
    copy(surface, this.#borneBy);
    this.#obstacles.velocityAt(met, surface);
    this.#pushed.addVelocity(met, surface);
    this.#brake(most, mass);
    copy(this.#borneBy, surface);
  }

  #brake(most: number, mass: number): void {
    const speed = this.#slide();
    if (speed === 0) return;
    const along = this.#along;
    const softness = mass > 0 ? mass * this.#pushed.softness(this.#met, along, 0) : 0;
    this.#give(along, 0, -Math.min(speed, most * (1 + softness)), mass);
  }

  /**
   * How fast it slides, m/s, now or after what drag and push do to it in the rest of the step; where it does, `#along` is that
   * way.
   */
  #slide(later?: Drift): number {
    const { left, speedOfPush } = later ?? NOTHING;
    const along = this.#along;
    let off = 0;
    for (let i = 0; i < 3; i++) {
      along[i] = this.#velocity[i]! * left + this.#push[i]! * speedOfPush - this.#surface[i]!;
      off += along[i]! * this.#met[MET.normal + i]!;
    }
    let square = 0;
    for (let i = 0; i < 3; i++) {
      along[i] = along[i]! - off * this.#met[MET.normal + i]!;
      square += along[i]! ** 2;
    }
    const speed = Math.sqrt(square);
    if (speed > 0) for (let i = 0; i < 3; i++) along[i] = along[i]! / speed;
    return speed;
  }

  /**
   * At the end of the step it goes as what bears it, which brakes it: to a stand, at most. `pull`: what would take it in,
   * m/s²; `rest`: what is left of the step.
   */
  #bear(friction: number, pull: number, rest: Drift): void {
    if (pull >= 0) return;
    const push = this.#push;
    const met = this.#met;
    copy(met, this.#borne);
    for (let i = 0; i < 3; i++) push[i] = push[i]! - pull * met[MET.normal + i]!;
    this.#bearing = -pull;
    this.#braking = Math.min(this.#slide(rest) / rest.speedOfPush, friction * -pull);
    copy(this.#along, this.#braked);
    for (let i = 0; i < 3; i++) push[i] = push[i]! - this.#braking * this.#along[i]!;
  }
}
