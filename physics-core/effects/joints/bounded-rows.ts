import { perStep, softnessAtStep } from '../../dynamics/levels.js';
import type { Joint, Motor, Stop } from '../../dynamics/joint.js';
import { ROWS } from '../../solver/joints/blocks.js';
import type { Component } from '../../solver/joints/forest.js';
import type { LockedRows } from './locked-rows.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from '../../solver/joints/row-system.js';
import { StopBounce } from './stop-bounce.js';

/** Below this rate (rad/s, m/s) a stop holds instead of bouncing. */
const LEAST_BOUNCE = 0.01;

export const isBounded = ({ stops, motors }: Joint): boolean =>
  stops.length > 0 || motors.length > 0;

/** A stop or a motor in a step: its row, as the 6-DoF numbers them, and the impulse it has, between two bounds. */
export interface Bound {
  row: number;
  least: number;
  most: number;
  impulse: number;
  /** The rate it holds to. */
  target: number;
}

/** Told which stops are in the way of a joint. */
export interface StopListener {
  note(joint: Joint, stop: Stop, value: number, side: -1 | 0 | 1): void;
}

/** Stops, which push one way only, and motors, which push as hard as they can: rows behind the locked ones of a joint. */
export class BoundedRows {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  readonly #rows: LockedRows;
  #joints: readonly Joint[] = [];
  /** Per row: where it stands, and on which side of a stop. */
  #values = new Float64Array(0);
  #sides = new Int8Array(0);
  /** Per row: its rate in the last step and how a step changes it; its rate after a bounce, and the mean one meanwhile. */
  #rates = new Float64Array(0);
  #changes = new Float64Array(0);
  #bounced = new Float64Array(0);
  #landings = new Float64Array(0);
  readonly #meeting = new StopBounce();
  readonly #bound: Bound = { row: 0, least: 0, most: 0, impulse: 0, target: 0 };

  constructor(system: RowSystem, bodies: JointedBodies, rows: LockedRows) {
    this.#system = system;
    this.#bodies = bodies;
    this.#rows = rows;
  }

  take(joints: readonly Joint[]): void {
    this.#joints = joints;
    if (this.#values.length < joints.length * ROWS) {
      this.#values = new Float64Array(joints.length * 2 * ROWS);
      this.#sides = new Int8Array(joints.length * 2 * ROWS);
      this.#rates = new Float64Array(joints.length * 2 * ROWS);
      this.#changes = new Float64Array(joints.length * 2 * ROWS);
      this.#bounced = new Float64Array(joints.length * 2 * ROWS);
      this.#landings = new Float64Array(joints.length * 2 * ROWS);
    }
    this.#rates.fill(NaN);
    this.#landings.fill(NaN);
    this.#joints.forEach(({ stops, motors }, k) => {
      const first = k * ROWS + this.#rows.count(k);
      const count = stops.length + motors.length;
      this.#system.rowCount[k] = this.#rows.count(k) + count;
      for (let i = first; i < first + count; i++) this.#system.forget(i);
    });
  }

  /** What the next step asks of the last one: ROWS numbers of each joint. */
  get lasting(): Float64Array {
    return this.#rates;
  }

  /** Whether a joint has stops or motors. */
  any(k: number): boolean {
    return this.#joints[k]!.stops.length + this.#joints[k]!.motors.length > 0;
  }

  /** Rows of one joint, after its locked ones; returns the worst overshoot past a stop. */
  fill(k: number, dt: number): number {
    const { stops, motors } = this.#joints[k]!;
    let r = this.#rows.count(k);
    let worst = 0;
    for (const stop of stops) worst = Math.max(worst, this.#fillStop(k, r++, stop, dt));
    for (const motor of motors) this.#fillMotor(k, r++, motor, dt);
    return worst;
  }

  #fillStop(k: number, r: number, stop: Stop, dt: number): number {
    const i = k * ROWS + r;
    const value = (this.#values[i] = this.#rows.fillRow(k, r, stop.row, dt));
    const side = stop.high - value < value - stop.low ? 1 : -1;
    this.#sides[i] = side;
    this.#noteChange(k, r);
    this.#system.bounded(i, side > 0 ? -Infinity : 0, side > 0 ? 0 : Infinity);
    return Math.max(0, this.#beyond(i, stop));
  }

  #beyond(i: number, { low, high }: Stop): number {
    return this.#sides[i]! > 0 ? this.#values[i]! - high : low - this.#values[i]!;
  }

  #fillMotor(k: number, r: number, { row, target, most }: Motor, dt: number): void {
    const i = k * ROWS + r;
    const strength = most * dt * this.#rows.launchShare(k);
    this.#rows.fillRow(k, r, row, dt);
    this.#system.compliance[i] = 0;
    this.#system.targetVelocity[i] = this.#system.threshold[i] = target;
    this.#system.bounded(i, -strength, strength);
  }

  /** For a solution in ways instead of velocities: hard stops end where they are, motors do not act. */
  setWholeTargets(k: number): void {
    const { stops } = this.#joints[k]!;
    const { rowCount, threshold, targetVelocity, compliance } = this.#system;
    let i = k * ROWS + this.#rows.count(k);
    const end = k * ROWS + rowCount[k]!;
    for (const stop of stops) {
      threshold[i] = targetVelocity[i] = -this.#sides[i]! * this.#beyond(i, stop);
      if (compliance[i] !== 0) this.#release(i);
      i++;
    }
    for (; i < end; i++) this.#release(i);
  }

  /** Whether a stop of a joint was in its way in the last step. */
  stopped(k: number): boolean {
    const first = this.#firstStop(k);
    for (let i = first; i < first + this.#joints[k]!.stops.length; i++)
      if (this.#system.holds(i)) return true;
    return false;
  }

  /** Stops are in nobody's way. */
  letStops(k: number): void {
    const first = this.#firstStop(k);
    for (let i = first; i < first + this.#joints[k]!.stops.length; i++) this.#release(i);
  }

  #release(i: number): void {
    this.#system.threshold[i] = -Infinity;
    this.#system.bounded(i, 0, 0);
  }

  /** The rates that stops are to have: that of a bounce, or one that ends at the stop. */
  setTargets(k: number, dt: number, repair: 0 | 1): void {
    const { stops } = this.#joints[k]!;
    let r = this.#rows.count(k);
    for (const stop of stops) this.#setStopTarget(k, r++, stop, dt, repair);
  }

  #setStopTarget(k: number, r: number, stop: Stop, dt: number, repair: 0 | 1): void {
    const i = k * ROWS + r;
    const side = this.#sides[i]!;
    const beyond = this.#beyond(i, stop);
    const { compliance } = this.#system;
    compliance[i] = softnessAtStep(stop.softness, stop.correction, dt) / dt;
    const share = beyond > 0 ? repair * perStep(stop.correction, dt) : 1;
    const held = -share * (beyond / dt);
    const closing = side * this.#bodies.rateNow(k, r);
    const bounces = stop.bounce > 0 && closing > LEAST_BOUNCE;
    if (bounces) this.#meeting.meet(closing, side * this.#changes[i]!, -beyond / dt, stop.bounce);
    this.#landings[i] = bounces ? side * this.#meeting.mean : NaN;
    this.#system.threshold[i] = side * held;
    this.#bounced[i] = side * this.#meeting.rate;
    this.#system.targetVelocity[i] = bounces ? this.#bounced[i]! : side * held;
  }

  /** Once the motion is found: where the step takes what bounces in it. False: nothing does. */
  setLandingTargets({ rows }: Component): boolean {
    let bounced = false;
    for (const k of rows) bounced = this.#setLandingTarget(k) || bounced;
    return bounced;
  }

  #setLandingTarget(k: number): boolean {
    const { targetVelocity, rowCount } = this.#system;
    let bounced = false;
    for (let i = this.#firstStop(k); i < k * ROWS + rowCount[k]!; i++) {
      if (Number.isNaN(this.#landings[i]!) || !this.#system.holds(i)) continue;
      targetVelocity[i] = this.#landings[i]!;
      bounced = true;
    }
    return bounced;
  }

  #firstStop(k: number): number {
    return k * ROWS + this.#rows.count(k);
  }

  /** How a step changes the rate of a row, by the last two. */
  #noteChange(k: number, r: number): void {
    const i = k * ROWS + r;
    const known = this.#rows.launchShare(k) === 1 && !Number.isNaN(this.#rates[i]!);
    this.#changes[i] = known ? this.#bodies.rateNow(k, r) - this.#rates[i]! : 0;
  }

  /** Once the motion is found: the same, and the share of the overshoot on top that is repaired, however soft the stop. */
  setRepairTargets(k: number, dt: number): void {
    const { stops } = this.#joints[k]!;
    let r = this.#rows.count(k);
    for (const stop of stops) this.#setRepairTargets(k, r++, stop, dt);
  }

  #setRepairTargets(k: number, r: number, stop: Stop, dt: number): void {
    const i = k * ROWS + r;
    const beyond = this.#beyond(i, stop);
    if (beyond <= 0) return;
    const back = (perStep(stop.correction, dt) * beyond) / dt;
    const { threshold, targetVelocity, compliance } = this.#system;
    // What comes back by itself faster than that needs no help.
    const rate = this.#system.holds(i) ? this.#system.rate(k, r) : 0;
    compliance[i] = 0;
    threshold[i] = targetVelocity[i] = rate - this.#sides[i]! * back;
  }

  /** Visits those of one joint, as one object that is written anew. */
  each(k: number, visit: (bound: Bound) => void): void {
    const { stops, motors } = this.#joints[k]!;
    let i = k * ROWS + this.#rows.count(k);
    for (const { row } of stops) this.#visit(i++, row, visit);
    for (const { row } of motors) this.#visit(i++, row, visit);
  }

  #visit(i: number, row: number, visit: (bound: Bound) => void): void {
    const { least, most, impulse, targetVelocity, threshold } = this.#system;
    const bound = this.#bound;
    bound.row = row;
    bound.least = least[i]!;
    bound.most = most[i]!;
    const holds = this.#system.holds(i);
    const edge = Number.isFinite(bound.least) && Number.isFinite(bound.most);
    bound.impulse = holds || edge ? impulse[i]! : 0;
    bound.target = holds ? targetVelocity[i]! : threshold[i]!;
    visit(bound);
  }

  /** Tells which stops held in this step. */
  tell(k: number, listener: StopListener): void {
    const joint = this.#joints[k]!;
    let i = k * ROWS + this.#rows.count(k);
    for (const stop of joint.stops) {
      const side = this.#system.holds(i) ? (this.#sides[i] as -1 | 1) : 0;
      listener.note(joint, stop, this.#values[i]!, side);
      const bounced = side !== 0 && !Number.isNaN(this.#landings[i]!);
      this.#rates[i] = bounced
        ? this.#bounced[i]! - this.#changes[i]!
        : this.#bodies.rateNow(k, i - k * ROWS);
      i++;
    }
  }
}
