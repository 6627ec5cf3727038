import { dot3 } from '../../base/flat-math.js';
import type { Joint } from '../../dynamics/joint.js';
import { ROW_BLOCK, ROWS, SIDE } from '../../solver/joints/blocks.js';
import type { JointEnds } from './joint-ends.js';
import { LINEAR } from './joint-geometry.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { NextPoses } from './next-poses.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/**
 * The rows by which joints hold their bodies, other than by pins, written into the system anew for each step: which way
 * each row pulls, and the rate at which its error is to shrink. Rows are numbered as in
 * `JointGeometry`.
 */
export class LockedRows {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  readonly #next: NextPoses;
  readonly #ends: JointEnds;
  /** Per joint: how many of its rows are locked. Per row: its number, where it is locked, and the erp of its error repaired per step. */
  #counts = new Uint8Array(0);
  #numbers = new Uint8Array(0);
  #targets = new Float64Array(0);
  #erps = new Float64Array(0);
  /** Errors at the start of the step. */
  #errors = new Float64Array(0);
  /** What `correct` asked for in the last step: the round ways of the next one are nearly the same. */
  #nonlinearCorrections = new Float64Array(0);

  constructor(system: RowSystem, bodies: JointedBodies, next: NextPoses, ends: JointEnds) {
    this.#system = system;
    this.#bodies = bodies;
    this.#next = next;
    this.#ends = ends;
  }

  take(joints: readonly Joint[]): void {
    if (this.#numbers.length < joints.length * ROWS) this.#grow(joints.length * 2);
    joints.forEach((joint, k) => this.#takeJoint(joint, k));
    this.#nonlinearCorrections.fill(0);
  }

  #grow(room: number): void {
    this.#counts = new Uint8Array(room);
    this.#numbers = new Uint8Array(room * ROWS);
    this.#targets = new Float64Array(room * ROWS);
    this.#erps = new Float64Array(room * ROWS);
    this.#errors = new Float64Array(room * ROWS);
    this.#nonlinearCorrections = new Float64Array(room * ROWS);
  }

  /** What the next step asks of the last one: ROWS numbers of each joint. */
  get lasting(): Float64Array {
    return this.#nonlinearCorrections;
  }

  #takeJoint(joint: Joint, k: number): void {
    const rows = this.#system.isPin[k]
      ? joint.lockedRows.filter((number) => number >= LINEAR)
      : joint.lockedRows;
    this.#counts[k] = rows.length;
    rows.forEach((number, r) => {
      const i = k * ROWS + r;
      const { erp, softness } = joint.corrections[number]!;
      this.#numbers[i] = number;
      this.#targets[i] = joint.limits[number]![0];
      this.#erps[i] = erp;
      this.#system.compliance[i] = softness;
      this.#system.unbounded(i);
    });
  }

  /** How many rows of a joint are locked: the bounded ones lie behind them. */
  count(k: number): number {
    return this.#counts[k]!;
  }

  /**
   * Whether all that a joint keeps of how its bodies are turned is the angle between two axes: a body that has gone as far as
   * that lets it is turned back in no time.
   */
  crosses(k: number): boolean {
    let angular = 0;
    for (let i = k * ROWS; i < k * ROWS + this.#counts[k]!; i++)
      if (this.#numbers[i]! >= LINEAR) angular++;
    return angular === 1;
  }

  /** Whether a locked row of a joint gives way. */
  anySoft(k: number): boolean {
    for (let i = k * ROWS; i < k * ROWS + this.#counts[k]!; i++)
      if (this.#system.compliance[i] !== 0) return true;
    return false;
  }

  // ---- a step -------------------------------------------------------------------------------------------------------

  /** Rows of one joint at the poses the step begins with; returns the worst error, metres or radians. */
  fill(k: number, dt: number): number {
    const { place, turn } = this.#bodies;
    this.#ends.read(k, place, turn);
    const { compliance } = this.#system;
    let worst = 0;
    for (let r = 0; r < this.#counts[k]!; r++) {
      const i = k * ROWS + r;
      this.#errors[i] = this.fillRow(k, r, this.#numbers[i]!, dt) - this.#targets[i]!;
      if (compliance[i] === 0) worst = Math.max(worst, Math.abs(this.#errors[i]!));
    }
    return worst;
  }

  /** One row of the joint that was filled last; returns where it stands, metres or radians. */
  fillRow(k: number, r: number, number: number, dt: number): number {
    if (number < LINEAR) this.#fillLinear(k, r, number);
    else this.#fillAngular(k, r, number);
    this.#system.carriedRate[k * ROWS + r] = this.#ends.moves(k)
      ? this.#carriedRate(k, r, number, dt)
      : 0;
    return this.#ends.geometry.value(number);
  }

  /** Share of the forces of this step that act on the joint: a half in the first step of its bodies. */
  launchShare(k: number): number {
    const { a, b } = this.#ends.edges[k]!;
    return this.#bodies.launching(a) || this.#bodies.launching(b) ? 0.5 : 1;
  }

  /** The rates at which errors are to shrink; `repair` 0 leaves those of hard rows as they are. */
  setTargets(k: number, dt: number, repair: 0 | 1): void {
    const { targetVelocity, compliance } = this.#system;
    for (let i = k * ROWS; i < k * ROWS + this.#counts[k]!; i++) {
      const hard = compliance[i] === 0;
      const erp = hard ? repair * this.#erps[i]! : this.#erps[i]!;
      if (!hard || repair === 0) this.#nonlinearCorrections[i] = 0;
      targetVelocity[i] = (-erp * this.#errors[i]!) / dt + this.#nonlinearCorrections[i]!;
    }
  }

  /** Forgets what round ways asked for. */
  forgetCorrections(k: number): void {
    this.#nonlinearCorrections.fill(0, k * ROWS, (k + 1) * ROWS);
  }

  /** For a solution in ways instead of velocities: hard rows lose all their error. */
  setWholeTargets(k: number): void {
    const { targetVelocity, compliance } = this.#system;
    for (let i = k * ROWS; i < k * ROWS + this.#counts[k]!; i++)
      targetVelocity[i] = compliance[i] === 0 ? -this.#errors[i]! : 0;
  }

  /**
   * By how much the step would miss: the rows are straight, the way of the bodies is round. The rates asked for are
   * corrected so that what is left of the errors after the step is what shall be left. Soft rows are not held to that.
   * Returns the worst miss, metres or radians.
   */
  correct(k: number, dt: number, repair: 0 | 1): number {
    const { place, turn } = this.#next;
    this.#ends.read(k, place, turn, 1);
    const { targetVelocity, compliance } = this.#system;
    let worst = 0;
    for (let r = 0; r < this.#counts[k]!; r++) {
      const i = k * ROWS + r;
      if (compliance[i] !== 0) continue;
      const left = (1 - repair * this.#erps[i]!) * this.#errors[i]!;
      const miss = this.#ends.geometry.value(this.#numbers[i]!) - this.#targets[i]! - left;
      targetVelocity[i]! -= miss / dt;
      this.#nonlinearCorrections[i]! -= miss / dt;
      worst = Math.max(worst, Math.abs(miss));
    }
    return worst;
  }

  #fillLinear(k: number, r: number, number: number): void {
    const at = k * 2 * ROW_BLOCK + r * SIDE;
    const { a, b } = this.#ends.edges[k]!;
    this.#fillLine(at, a, number, 1);
    this.#fillLine(at + ROW_BLOCK, b, number, -1);
  }

  #fillLine(at: number, body: number, number: number, sign: 1 | -1): void {
    const { jacobian } = this.#system;
    const { geometry } = this.#ends;
    if (body < 0) geometry.writeAlong(jacobian, at, number, sign);
    else geometry.writeLinear(jacobian, at, number, this.#bodies.place, body * 3, sign);
  }

  #fillAngular(k: number, r: number, number: number): void {
    const one = k * 2 * ROW_BLOCK + r * SIDE;
    this.#ends.geometry.writeAngular(this.#system.jacobian, one, one + ROW_BLOCK, number);
  }

  /** The rate of a row that carried bodies give it. */
  #carriedRate(k: number, r: number, number: number, dt: number): number {
    const { a, b } = this.#ends.edges[k]!;
    const at = k * 2 * ROW_BLOCK + r * SIDE;
    let rate = 0;
    if (a < 0) rate += this.#rateOfEnd(k, 0, at, number, dt);
    if (b < 0) rate += this.#rateOfEnd(k, 1, at + ROW_BLOCK, number, dt);
    return rate;
  }

  /** Rows along axes are measured at the point that body 2 carries. */
  #rateOfEnd(k: number, which: 0 | 1, at: number, number: number, dt: number): number {
    const { jacobian } = this.#system;
    const { one, two } = this.#ends.geometry;
    const rates = this.#ends.rates(k, which, dt);
    if (number >= LINEAR) return dot3(jacobian, at + 3, rates, 3);
    if (which === 0) addTurning(rates, one.origin, two.origin);
    return dot3(jacobian, at, rates, 0);
  }
}

/** The velocity of an origin becomes that of another point of the same body. */
function addTurning(rates: Float64Array, origin: Float64Array, point: Float64Array): void {
  const x = point[0]! - origin[0]!;
  const y = point[1]! - origin[1]!;
  const z = point[2]! - origin[2]!;
  rates[0]! += rates[4]! * z - rates[5]! * y;
  rates[1]! += rates[5]! * x - rates[3]! * z;
  rates[2]! += rates[3]! * y - rates[4]! * x;
}
