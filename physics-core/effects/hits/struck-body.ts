import { multiply4, writeTurn } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import { holds, isJointed } from '../../dynamics/jointed.js';
import { otherEnd } from '../../dynamics/other-end.js';
import type { Engine } from '../../engine/engine.js';
import { EffectiveMassMatrix } from './effective-mass-matrix.js';
import type { JointRows } from '../joints/joint-rows.js';
import type { Impact } from './impact.js';

/** Linear, then angular. */
const WIDTH = 6;

/** Hits of one body in a step; the balls of a cradle take fewer, those of a heap would take hundreds. */
const MOST_STRIKES = 24;

/** How much more than its weight may act on it, as a square: rounding. */
const EVEN = 1.02;

const pose = new Float64Array(POSE);
const velocity = new Float64Array(6);
const displacement = new Float64Array(3);
const turn = new Float64Array(4);

/** A body that is hit, and where. */
export class StruckBody {
  readonly effectiveMass: EffectiveMassMatrix;
  readonly hits: Impact[] = [];
  body!: Body;
  movable = false;
  /** Whether the joint solve moves it, and whether others that move hang on it. */
  jointed = false;
  hangs = false;
  /** Whether half its weight or more was borne in the last step of Bullet: by what that solves alone, or hits as well. */
  carried = false;
  borne = false;
  /** The step of Bullet that it was last touched in. */
  #touchedIn = -1;
  /** In this step of Bullet. */
  strikes = 0;
  /** The step that it belongs to. */
  step = -1;
  /** Whether its effectiveMass is known in this step, and it was struck. */
  #known = false;
  struck = false;
  /** The step that it was last struck in. */
  struckIn = -1;
  /** Velocity as Bullet's step begins. */
  readonly #start = new Float64Array(WIDTH);
  #weighed = false;
  /** Velocity before it was struck. */
  readonly before = new Float64Array(WIDTH);
  /** When Bullet's solver lets it bounce, seconds; NaN: it does not. */
  bounces = NaN;
  /** What hits changed of its velocity, and how far that is not yet on its way at the start of the step. */
  readonly change = new Float64Array(WIDTH);
  readonly late = new Float64Array(WIDTH);

  readonly #engine: Engine;

  constructor(engine: Engine, rows: () => JointRows) {
    this.#engine = engine;
    this.effectiveMass = new EffectiveMassMatrix(engine.ammo, rows);
  }

  /** `begins`: Bullet's step, so many after the first, is still to come. */
  take(body: Body, step: number, bulletStep: number, begins: boolean): void {
    this.step = step;
    if (bulletStep > this.#touchedIn + 1) this.carried = this.borne = false;
    if (bulletStep > this.#touchedIn) this.strikes = 0;
    this.#touchedIn = bulletStep;
    this.body = body;
    this.movable = body.movable;
    this.jointed = isJointed(body);
    this.hangs = hangsOnMoving(body);
    this.hits.length = 0;
    this.#known = this.struck = false;
    this.bounces = NaN;
    this.#weighed = begins && this.movable && !this.jointed;
    if (this.#weighed) this.#engine.reader.velocity(body.pointer, this.#start, 0);
  }

  /** Whether the last step of Bullet, this one, bore it. */
  isKnownIn(bulletStep: number): boolean {
    return this.#touchedIn === bulletStep;
  }

  goOn(bulletStep: number, carried: boolean, borne: boolean): void {
    this.#touchedIn = bulletStep;
    this.carried = carried;
    this.borne = borne;
  }

  /** What lies between others may be hit to and fro without end: from here on Bullet holds it against all of them at once. */
  get isSpent(): boolean {
    return this.movable && this.strikes >= MOST_STRIKES;
  }

  /** Once Bullet's step is over: what its weight should have given it, and hits did not, something took. */
  weigh(dt: number): void {
    const { pointer, gravity } = this.body;
    this.carried = this.borne = false;
    if (!this.#weighed || !this.body.active) return;
    this.#engine.reader.velocity(pointer, velocity, 0);
    let gained = 0;
    let due = 0;
    let hit = 0;
    for (let i = 0; i < 3; i++) {
      if (this.struck) hit += gravity[i]! * this.change[i]!;
      gained += gravity[i]! * (velocity[i]! - this.#start[i]!);
      due += gravity[i]! ** 2 * dt;
    }
    this.carried = gained - hit < due / 2;
    this.borne = gained < due / 2;
  }

  /** What a push would do to it now. */
  known(): EffectiveMassMatrix {
    if (!this.#known) this.effectiveMass.read(this.body);
    this.#known = true;
    return this.effectiveMass;
  }

  /** Applies an impulse of `effectiveMass` at a time of the step. */
  push(impulse: number, time: number): void {
    if (!this.struck) this.#begin();
    this.effectiveMass.push(impulse);
    for (let i = 0; i < WIDTH; i++) {
      const change = impulse * this.effectiveMass.change[i]!;
      this.change[i]! += change;
      this.late[i]! -= time * change;
    }
  }

  /** Bullet's solver will let it bounce, in several points together; the first of them tells the time. */
  bounce(time: number): void {
    if (!this.struck) this.#begin();
    if (!(this.bounces <= time)) this.bounces = time;
  }

  /** What Bullet's solver did beside what weight did. */
  #noteBounce(dt: number): void {
    const { gravity } = this.body;
    for (let i = 0; i < WIDTH; i++) {
      const weight = i < 3 ? gravity[i]! * dt : 0;
      const change = velocity[i]! - this.before[i]! - this.change[i]! - weight;
      this.change[i]! += change;
      this.late[i]! -= this.bounces * change;
    }
  }

  /** How far it is led back already at an arm from its centre of mass, along a normal, metres. */
  lateAt(arm: Float64Array, normal: Float64Array): number {
    if (!this.struck) return 0;
    const [u, v, w, p, q, r] = this.late;
    const rx = arm[0]!;
    const ry = arm[1]!;
    const rz = arm[2]!;
    return (
      normal[0]! * (u! + q! * rz - r! * ry) +
      normal[1]! * (v! + r! * rx - p! * rz) +
      normal[2]! * (w! + p! * ry - q! * rx)
    );
  }

  /** Moves the body from where Bullet has taken it to where its hits take it. */
  makeUp(dt: number): void {
    const { reader, scratch } = this.#engine;
    const { body, jointed, before, change, late } = this;
    // Those that hang on others that move had their blow alone: the joint solve brings the rest along.
    if (!this.struck || !body.active || this.hangs) return;
    reader.pose(body.pointer, pose, 0);
    reader.velocity(body.pointer, velocity, 0);
    if (this.bounces === this.bounces && !jointed) this.#noteBounce(dt);
    const evenly = !jointed && this.#isEven(dt);
    for (let i = 0; i < 3; i++) {
      pose[i]! += late[i]!;
      if (evenly) pose[i]! -= (dt / 2) * (velocity[i]! - before[i]! - change[i]!);
      displacement[i] = late[3 + i]!;
    }
    writeTurn(turn, displacement, 1);
    multiply4(turn, turn, 0, pose, 3);
    body.body.setCenterOfMassTransform(scratch.transform(pose, turn));
  }

  /** Whether no more than its weight acted beside its hits. The joint solve has its own account of weight. */
  #isEven(dt: number): boolean {
    let rest = 0;
    let weight = 0;
    for (let i = 0; i < 3; i++) {
      rest += (velocity[i]! - this.before[i]! - this.change[i]!) ** 2;
      weight += (this.body.gravity[i]! * dt) ** 2;
    }
    return rest <= EVEN * weight;
  }

  #begin(): void {
    this.struck = true;
    this.struckIn = this.step;
    const { pointer } = this.body;
    this.#engine.reader.velocity(pointer, this.before, 0);
    this.change.fill(0);
    this.late.fill(0);
  }
}

/** Whether a joint holds a body to another one that moves. */
function hangsOnMoving(body: Body): boolean {
  for (const joint of body.joints) if (holds(joint) && otherEnd(joint, body)?.movable) return true;
  return false;
}
