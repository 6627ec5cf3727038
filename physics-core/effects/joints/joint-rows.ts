import type { Body, MassProperties } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { backward, factor, forward, rowOf } from '../../base/cholesky.js';
import { applyInverseInertia, multiply4, place, writeTurn } from '../../base/flat-math.js';
import { writeAxes } from '../../base/matrix.js';
import type { Pose } from '../../base/math.js';
import { atan2, hypot } from '../../base/exact/index.js';
import { JointGeometry, LINEAR, type End } from './joint-geometry.js';

/** Velocities of both bodies: linear and angular of body1, then of body2. */
const WIDTH = 12;
const ROWS = 6;

/** The centre of mass of a side, and its principal axes as columns: x, y, z, three numbers each. */
class Centre {
  readonly pose = new Float64Array(POSE);
  readonly principal = new Float64Array(9);
  /** Of a body that moves. */
  mass: MassProperties | undefined;
}

/** Where a step that begins takes bodies. */
export interface Ahead {
  dt: number;
  /** Six numbers: linear, then angular. */
  readVelocity(body: Body, out: Float64Array): void;
  /** The same of what it is moved by before. False: it is not. */
  readDisplacement(body: Body, out: Float64Array): boolean;
}

/** Six numbers of a velocity, from `at` on. */
export interface Shown {
  readonly velocities: Float64Array;
  readonly at: number;
}

/**
 * The six rows of one joint in double precision, and what an impulse along one does while the locked ones hold. Made once
 * and filled for one joint after the other: nothing is allocated in a step.
 */
export class JointRows {
  readonly #simulation: Simulation;
  /** J: the rates of the rows from the velocities. */
  readonly jacobian = new Float64Array(ROWS * WIDTH);
  /** M⁻¹ Jᵀ: the velocities that a unit impulse along each row gives. */
  readonly response = new Float64Array(ROWS * WIDTH);
  /** Metres and radians since the joint was made. */
  readonly values = new Float64Array(ROWS);
  /** Velocities now. */
  readonly #now = new Float64Array(WIDTH);
  readonly #geometry = new JointGeometry();
  readonly #one = new Centre();
  readonly #two = new Centre();
  #joint!: Joint;
  #ahead: Ahead | undefined;
  readonly #step = new Float64Array(6);
  readonly #spin = new Float64Array(3);
  readonly #turn = new Float64Array(4);
  #dt = 0;
  #locked: readonly number[] = [];
  readonly #factors = new Float64Array(rowOf(ROWS));
  readonly #coupling = new Float64Array(ROWS);
  readonly #held = new Float64Array(ROWS);
  readonly #impulse = new Float64Array(WIDTH);

  /** Rate of the row looked at. */
  rate = 0;
  /** Its change per unit of impulse along it while the locked rows hold. */
  inverseEffectiveMass = 0;

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  /** Takes on a joint. False: nothing of it moves in this step. */
  read(joint: Joint, dt: number): boolean {
    if (!joint.attached || (still(joint.body1) && still(joint.body2))) return false;
    this.fill(joint, dt);
    return this.#factor();
  }

  /** Only its rows, values and velocities. */
  fill(joint: Joint, dt: number): void {
    this.#dt = dt;
    this.#locked = joint.lockedRows;
    this.#look(joint);
    for (let row = 0; row < ROWS; row++) {
      this.values[row] = this.#geometry.value(row);
      this.add(row);
    }
  }

  /** Only those of its rows that are locked, without values; others by `add`. */
  fillLocked(joint: Joint): void {
    this.#look(joint);
    for (const row of joint.lockedRows) this.add(row);
  }

  /** One row of the joint. */
  add(row: number): void {
    this.#fillRow(row);
    this.#respond(row, 0, this.#one);
    this.#respond(row, 6, this.#two);
  }

  /** The same where its bodies will be. */
  fillAhead(joint: Joint, ahead: Ahead): void {
    this.#ahead = ahead;
    this.fill(joint, ahead.dt);
    this.#ahead = undefined;
  }

  /** Only where its locked rows will stand. */
  lookAhead(joint: Joint, ahead: Ahead): void {
    this.#ahead = ahead;
    this.#look(joint);
    this.#ahead = undefined;
    for (const row of joint.lockedRows) this.values[row] = this.#geometry.value(row);
  }

  /** From the centre of mass of body 1 or 2 to the point that its rows were filled at. */
  readArm(body: 1 | 2, out: Float64Array): void {
    const { pose } = body === 1 ? this.#one : this.#two;
    const { origin } = this.#geometry.two;
    for (let x = 0; x < 3; x++) out[x] = origin[x]! - pose[x]!;
  }

  /** Where one row of a joint stands now. */
  valueOf(joint: Joint, row: number): number {
    this.#look(joint);
    return this.#geometry.value(row);
  }

  /** Its rate, per second. `shown`: the velocity of a body at this moment, from `at` on, where it has another. */
  rateOf(joint: Joint, row: number, shown: (body: Body) => Shown | undefined): number {
    this.#look(joint);
    this.#takeShown(joint.body1 && shown(joint.body1), 0);
    this.#takeShown(joint.body2 && shown(joint.body2), 6);
    this.#fillRow(row);
    return this.rateNow(row);
  }

  #takeShown(shown: Shown | undefined, at: number): void {
    if (shown) this.#now.set(shown.velocities.subarray(shown.at, shown.at + 6), at);
  }

  // ---- both sides ---------------------------------------------------------------------------------------------------

  #look(joint: Joint): void {
    this.#joint = joint;
    this.#readEnd(this.#one, this.#geometry.one, joint.body1, joint.centred1, 0);
    this.#readEnd(this.#two, this.#geometry.two, joint.body2, joint.centred2, 6);
    this.#geometry.look();
  }

  #readEnd(
    centre: Centre,
    { origin, axes }: End,
    body: Body | undefined,
    frame: Pose,
    at: number,
  ): void {
    const { pose, principal } = centre;
    this.#readBody(pose, body, at);
    centre.mass = body?.movable ? body.mass : undefined;
    writeAxes(principal, pose, 3);
    place(origin, axes, pose, principal, frame);
  }

  #readBody(pose: Float64Array, body: Body | undefined, at: number): void {
    if (!body) {
      pose.set(ORIGIN);
      this.#now.fill(0, at, at + 6);
      return;
    }
    const { reader } = this.#simulation.engine;
    reader.pose(body.pointer, pose, 0);
    reader.velocity(body.pointer, this.#now, at);
    if (this.#ahead) this.#moveOn(pose, body, this.#ahead);
  }

  /** As it is displaced, and then moved and turned by Bullet. */
  #moveOn(pose: Float64Array, body: Body, ahead: Ahead): void {
    const v = this.#step;
    if (ahead.readDisplacement(body, v)) {
      const angle = hypot(v[3]!, v[4]!, v[5]!);
      this.#moveBy(pose, v, 1, angle > 0 ? atan2(angle, 1) / angle : 1);
    }
    ahead.readVelocity(body, v);
    this.#moveBy(pose, v, ahead.dt, ahead.dt);
  }

  #moveBy(pose: Float64Array, v: Float64Array, time: number, turning: number): void {
    for (let x = 0; x < 3; x++) {
      pose[x]! += time * v[x]!;
      this.#spin[x] = v[3 + x]!;
    }
    writeTurn(this.#turn, this.#spin, turning);
    multiply4(this.#turn, this.#turn, 0, pose, 3);
    pose.set(this.#turn, 3);
  }

  #fillRow(row: number): void {
    const o = row * WIDTH;
    if (row >= LINEAR) {
      this.#geometry.writeAngular(this.jacobian, o, o + 6, row);
      return;
    }
    this.#geometry.writeLinear(this.jacobian, o, row, this.#one.pose, 0, 1);
    this.#geometry.writeLinear(this.jacobian, o + 6, row, this.#two.pose, 0, -1);
  }

  #respond(row: number, at: number, { principal, mass }: Centre): void {
    const { jacobian, response } = this;
    const o = row * WIDTH + at;
    if (!mass) {
      response.fill(0, o, o + 6);
      return;
    }
    for (let i = o; i < o + 3; i++) response[i] = jacobian[i]! / mass.mass;
    applyInverseInertia(response, o + 3, principal, mass.moments, jacobian, o + 3);
  }

  // ---- J M⁻¹ Jᵀ -------------------------------------------------------------------------------------------------------

  /** How two rows act on each other. */
  between(a: number, b: number): number {
    const { jacobian, response } = this;
    let sum = 0;
    for (let i = 0; i < WIDTH; i++) sum += jacobian[a * WIDTH + i]! * response[b * WIDTH + i]!;
    return sum;
  }

  rateNow(row: number): number {
    let sum = 0;
    for (let i = 0; i < WIDTH; i++) sum += this.jacobian[row * WIDTH + i]! * this.#now[i]!;
    return sum;
  }

  #factor(): boolean {
    const rows = this.#locked;
    const n = rows.length;
    for (let i = 0; i < n; i++)
      for (let j = 0; j <= i; j++) this.#factors[rowOf(i) + j] = this.between(rows[i]!, rows[j]!);
    return factor(this.#factors, 0, n);
  }

  /** Fills `rate` and `inverseEffectiveMass` for a row that is not locked. */
  look(row: number): void {
    const rows = this.#locked;
    const n = rows.length;
    for (let i = 0; i < n; i++) this.#coupling[i] = this.between(rows[i]!, row);
    forward(this.#factors, 0, n, this.#coupling, 0);
    this.rate = this.rateNow(row);
    this.inverseEffectiveMass = this.between(row, row);
    for (let i = 0; i < n; i++) this.inverseEffectiveMass -= this.#coupling[i]! ** 2;
  }

  /** What gravity and its bodies' steady forces do to the row looked at while the locked rows hold, per second. */
  pull(row: number): number {
    const rows = this.#locked;
    const n = rows.length;
    for (let i = 0; i < n; i++) this.#held[i] = this.#pulled(rows[i]!);
    forward(this.#factors, 0, n, this.#held, 0);
    let pull = this.#pulled(row);
    for (let i = 0; i < n; i++) pull -= this.#coupling[i]! * this.#held[i]!;
    return pull;
  }

  #pulled(row: number): number {
    return (
      this.#pulledOn(this.#joint.body1, row * WIDTH) +
      this.#pulledOn(this.#joint.body2, row * WIDTH + 6)
    );
  }

  #pulledOn(body: Body | undefined, at: number): number {
    if (!body?.movable) return 0;
    const { gravity, mass, constantLoad } = body;
    const { force } = constantLoad;
    let sum = 0;
    for (let i = 0; i < 3; i++)
      sum += this.jacobian[at + i]! * (gravity[i]! + force[i]! / mass.mass);
    return sum;
  }

  /** An impulse along the row looked at, as forces for this step; the locked rows hold against it. */
  push(row: number, impulse: number): void {
    const rows = this.#locked;
    const n = rows.length;
    backward(this.#factors, 0, n, this.#coupling, 0);
    this.#impulse.fill(0);
    this.#add(row, impulse);
    for (let i = 0; i < n; i++) this.#add(rows[i]!, -this.#coupling[i]! * impulse);
    this.#apply(this.#joint.body1, 0);
    this.#apply(this.#joint.body2, 6);
  }

  #add(row: number, impulse: number): void {
    const o = row * WIDTH;
    for (let i = 0; i < WIDTH; i++) this.#impulse[i]! += this.jacobian[o + i]! * impulse;
  }

  #apply(body: Body | undefined, at: number): void {
    if (!body?.movable) return;
    const { scratch } = this.#simulation.engine;
    const push = this.#impulse;
    const dt = this.#dt;
    body.body.applyCentralForce(
      scratch.vector(push[at]! / dt, push[at + 1]! / dt, push[at + 2]! / dt),
    );
    body.body.applyTorque(
      scratch.vector(push[at + 3]! / dt, push[at + 4]! / dt, push[at + 5]! / dt),
    );
  }
}

const ORIGIN = [0, 0, 0, 0, 0, 0, 1];

const still = (body: Body | undefined): boolean => !body?.movable || body.sleeping;
