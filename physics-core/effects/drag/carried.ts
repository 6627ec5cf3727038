import { hypot } from '../../base/exact/index.js';
import {
  conjugate,
  length,
  multiply,
  rotationOf,
  scale,
  subtract,
  type Pose,
} from '../../base/math.js';
import { mix } from '../../base/mix.js';
import type { Vec3 } from '../../fields/types.js';
import type { Way } from '../joints/joint-ends.js';
import { SmoothWay, type PlaceInTime, type StepWay } from './smooth-way.js';

/**
 * Changes of speed and spin within a step, m/s and rad/s, from which on a move is a jump: an edit that brings a body
 * elsewhere. What shakes by 5 cm thirty times a second changes by 7.4 m/s in 1/240 s.
 */
const SUDDEN_SPEED = 10;
const SUDDEN_SPIN = 20;

/** rad/s: rounding of what does not turn is less. */
const TURNING = 1e-6;

type Speeds = [speed: Vec3, spin: Vec3];

/** How a body is moved along, for a snapshot. */
export interface KeptMove {
  now: Pose;
  to: Pose;
  from: Pose;
  since: number;
  duration: number;
  interval: number;
  jumped: boolean;
  paces: [step: Speeds, before: Speeds, wanted: Speeds];
  begun: readonly PlaceInTime[];
}

/** Speed and spin. */
class Pace {
  #speed: Vec3 = [0, 0, 0];
  #spin: Vec3 = [0, 0, 0];

  take(from: Pose, to: Pose, seconds: number): void {
    this.#speed = scale(subtract(to.p, from.p), 1 / seconds);
    this.#spin = scale(turnOf(from, to), 1 / seconds);
  }

  get numbers(): Speeds {
    return [this.#speed, this.#spin];
  }

  set numbers([speed, spin]: Speeds) {
    this.#speed = speed;
    this.#spin = spin;
  }

  copy(other: Pace): void {
    this.#speed = other.#speed;
    this.#spin = other.#spin;
  }

  /** More than motion would. */
  differs(other: Pace): boolean {
    return (
      length(subtract(this.#speed, other.#speed)) > SUDDEN_SPEED ||
      length(subtract(this.#spin, other.#spin)) > SUDDEN_SPIN
    );
  }
}

/** A fixed body that its author moves along: where its centre of mass is, and where it is going. */
export class Carried implements Way {
  /** In the step: from where to where. */
  now: Pose;
  next: Pose;
  /** Where it was told to be, when, and the seconds it takes to get there. */
  #to: Pose;
  since = -Infinity;
  #duration = 0;
  /** Seconds between the last two moves. */
  #interval = 0;
  /** It is there already, from where it was before: no motion, as joints see it. */
  jumped = false;
  #from: Pose;
  /** Of the step: linear, then angular. */
  readonly velocity = new Float64Array(6);
  /** At what pace its last step took it, and at what pace the moves before and after want it to go. */
  #step = new Pace();
  #before = new Pace();
  #wanted = new Pace();
  readonly #way = new SmoothWay();
  /** When the step began, and whether it is under way in it. */
  #time = 0;
  #goes = false;
  /** What is known of its way there. */
  #inStep: { way: StepWay | undefined } | undefined;

  constructor(at: Pose) {
    this.now = this.next = this.#to = this.#from = at;
  }

  /** Between steps. */
  save(): KeptMove {
    return structuredClone({
      now: this.now,
      to: this.#to,
      from: this.#from,
      since: this.since,
      duration: this.#duration,
      interval: this.#interval,
      jumped: this.jumped,
      paces: [this.#step.numbers, this.#before.numbers, this.#wanted.numbers],
      begun: this.#way.begun,
    });
  }

  static from(kept: KeptMove): Carried {
    const { now, to, from, since, duration, interval, jumped, paces, begun } =
      structuredClone(kept);
    const carried = new Carried(now);
    carried.#to = to;
    carried.#from = from;
    carried.since = since;
    carried.#duration = duration;
    carried.#interval = interval;
    carried.jumped = jumped;
    [carried.#step.numbers, carried.#before.numbers, carried.#wanted.numbers] = paces;
    carried.#way.begun = begun;
    return carried;
  }

  /** It is to be elsewhere; `turn`: seconds that pass before its author speaks again. */
  tell(to: Pose, time: number, turn: number, dt: number): void {
    // Position and orientation come one after the other: together they are one move.
    if (time !== this.since) this.#begin(time, turn, dt);
    this.#to = to;
    this.jumped = this.#isJump(turn > dt * 1.5 && this.#interval === 0);
    if (this.jumped) this.#way.forget();
    this.now = this.next = this.jumped ? to : this.#from;
  }

  #begin(time: number, turn: number, dt: number): void {
    const first = this.since === -Infinity;
    const interval = first ? 0 : time - this.since;
    this.#from = this.now;
    this.#way.begin(time, this.now.p);
    this.#before.copy(this.#wanted);
    // Who speaks before each step may do so before each second one only; frames are not all alike.
    if (first) this.#duration = turn;
    else if (turn > dt * 1.5) this.#duration = (this.#duration + interval) / 2;
    else this.#duration = Math.abs(interval - this.#interval) < dt / 2 ? interval : dt;
    this.#interval = interval;
    this.since = time;
  }

  /** `first`: nobody knows yet for how long it will take; so it is an edit. */
  #isJump(first: boolean): boolean {
    this.#wanted.take(this.#from, this.#to, this.#duration);
    return first || (this.#wanted.differs(this.#step) && this.#wanted.differs(this.#before));
  }

  /**
   * A step begins. Returns the pose that lies a step of its motion back; undefined for what jumped and stands there.
   */
  begin(time: number, dt: number): Pose | undefined {
    const left = this.#duration - (time - this.since);
    this.#time = time;
    this.#goes = left > dt / 2;
    this.#inStep = undefined;
    if (this.jumped)
      return left > dt / 2
        ? mix(this.#to, this.#from, Math.min(1, dt / this.#duration))
        : undefined;
    this.next = left < dt * 1.5 ? this.#to : mix(this.now, this.#to, dt / left);
    this.velocity.set(scale(subtract(this.next.p, this.now.p), 1 / dt));
    this.velocity.set(scale(turnOf(this.now, this.next), 1 / dt), 3);
    const { p, q } = this.now;
    const back = multiply(q, conjugate(this.next.q));
    return {
      p: subtract(scale(p, 2), this.next.p),
      q: multiply(back, q),
    };
  }

  /** That its move takes. */
  get seconds(): number {
    return this.#duration;
  }

  /** Where it goes in the step; undefined: it turns, stands, or goes no smooth way. */
  get way(): StepWay | undefined {
    return (this.#inStep ??= { way: this.#readWay() }).way;
  }

  #readWay(): StepWay | undefined {
    const v = this.velocity;
    if (!this.#goes || hypot(v[3]!, v[4]!, v[5]!) > TURNING) return undefined;
    return this.#way.from(this.#time, { time: this.since + this.#duration, p: this.#to.p });
  }

  /** The step is over: it is where it was going. */
  end(dt: number): void {
    this.#step.take(this.now, this.next, dt);
    this.now = this.next;
  }
}

/** The turn from one pose to another, radians about each axis. */
export function turnOf(from: Pose, to: Pose): Vec3 {
  const [x, y, z, angle] = rotationOf(multiply(to.q, conjugate(from.q)));
  return scale([x, y, z], angle);
}
