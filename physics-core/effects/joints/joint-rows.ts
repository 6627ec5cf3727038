import type { BodyNode } from '../../nodes/body.js';
import type { JointNode } from '../../nodes/joint.js';
import type { World } from '../../world/world.js';
import { backward, factor, forward } from '../../base/cholesky.js';
import { applyInverseInertia, arm, place, writeAxes } from '../../base/flat-math.js';
import { Gimbal } from './gimbal.js';

/** Velocities of both bodies: linear and angular of body1, then of body2. */
const WIDTH = 12;
const ROWS = 6;
const POSE = 7;

/** One side of a joint. Axes are columns: x, y, z, three numbers each. */
class End {
  readonly centre = new Float64Array(POSE);
  /** Principal axes of the body. */
  readonly principal = new Float64Array(9);
  /** The joint's frame as this side carries it. */
  readonly origin = new Float64Array(3);
  readonly axes = new Float64Array(9);
}

/**
 * The six rows of one joint as Bullet's 6-DoF has them, in double precision: 0 to 2 move body1 against body2 along the
 * axes of frame 1, 3 to 5 turn it about x of frame 2, about what is at right angles to both, and about z of frame 1.
 * Made once and filled for one joint after the other: nothing is allocated in a step.
 */
export class JointRows {
  readonly #world: World;
  /** J: the rates of the rows from the velocities. */
  readonly jacobian = new Float64Array(ROWS * WIDTH);
  /** M⁻¹ Jᵀ: the velocities that a unit impulse along each row gives. */
  readonly response = new Float64Array(ROWS * WIDTH);
  /** Metres and radians since the joint was made. */
  readonly values = new Float64Array(ROWS);
  /** Velocities now. */
  readonly #now = new Float64Array(WIDTH);
  readonly #one = new End();
  readonly #two = new End();
  readonly #gimbal = new Gimbal();
  #joint!: JointNode;
  #dt = 0;
  #locked: readonly number[] = [];
  readonly #factors = new Float64Array(ROWS * ROWS);
  readonly #coupling = new Float64Array(ROWS);
  readonly #held = new Float64Array(ROWS);
  readonly #impulse = new Float64Array(WIDTH);

  /** Rate of the row looked at. */
  rate = 0;
  /** Its change per unit of impulse along it while the locked rows hold. */
  inverseEffectiveMass = 0;

  constructor(world: World) {
    this.#world = world;
  }

  /** Takes on a joint. False: nothing of it moves in this step. */
  read(joint: JointNode, dt: number): boolean {
    if (!joint.attached || (still(joint.body1) && still(joint.body2))) return false;
    this.fill(joint, dt);
    return this.#factor();
  }

  /** Only its rows, values and velocities. */
  fill(joint: JointNode, dt: number): void {
    this.#joint = joint;
    this.#dt = dt;
    this.#locked = joint.lockedRows;
    this.#readEnd(this.#one, joint, 1, 0);
    this.#readEnd(this.#two, joint, 2, 6);
    this.#fillLinear();
    this.#fillAngular();
    for (let row = 0; row < ROWS; row++) {
      this.#respond(row, 0, joint.body1, this.#one);
      this.#respond(row, 6, joint.body2, this.#two);
    }
  }

  // ---- both sides ---------------------------------------------------------------------------------------------------

  #readEnd(end: End, joint: JointNode, which: 1 | 2, at: number): void {
    const body = which === 1 ? joint.body1 : joint.body2;
    const frame = which === 1 ? joint.centred1 : joint.centred2;
    const { reader } = this.#world.engine;
    end.centre.set(ORIGIN);
    if (body) reader.pose(body.body, body.pointer, end.centre, 0);
    writeAxes(end.principal, end.centre, 3);
    place(end.origin, end.axes, end.centre, end.principal, frame);
    this.#now.fill(0, at, at + 6);
    if (body) reader.velocity(body.body, body.pointer, this.#now, at);
  }

  #respond(row: number, at: number, body: BodyNode | undefined, end: End): void {
    const { jacobian, response } = this;
    const o = row * WIDTH + at;
    if (!body?.movable) {
      response.fill(0, o, o + 6);
      return;
    }
    for (let i = o; i < o + 3; i++) response[i] = jacobian[i]! / body.mass.mass;
    applyInverseInertia(response, o + 3, end.principal, body.mass.moments, jacobian, o + 3);
  }

  // ---- the rows -----------------------------------------------------------------------------------------------------

  /** Along the axes that body1 carries, at the point that body2 carries: what slides is measured there. */
  #fillLinear(): void {
    const { jacobian, values } = this;
    const [one, two] = [this.#one, this.#two];
    for (let row = 0; row < 3; row++) {
      const o = row * WIDTH;
      values[row] = 0;
      for (let i = 0; i < 3; i++) {
        const along = one.axes[row * 3 + i]!;
        jacobian[o + i] = along;
        jacobian[o + 6 + i] = -along;
        values[row]! += along * (one.origin[i]! - two.origin[i]!);
      }
      arm(jacobian, o + 3, two.origin, one.centre, one.axes, row * 3, 1);
      arm(jacobian, o + 9, two.origin, two.centre, one.axes, row * 3, -1);
    }
  }

  #fillAngular(): void {
    const { jacobian, values } = this;
    this.#gimbal.look(this.#one.axes, this.#two.axes);
    for (let row = 3; row < ROWS; row++) {
      const o = row * WIDTH;
      values[row] = this.#gimbal.angle(row);
      jacobian.fill(0, o, o + WIDTH);
      this.#gimbal.writeRate(row, jacobian, o + 3);
      for (let i = 0; i < 3; i++) jacobian[o + 9 + i] = -jacobian[o + 3 + i]!;
    }
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
      for (let j = 0; j < n; j++) this.#factors[i * n + j] = this.between(rows[i]!, rows[j]!);
    return factor(this.#factors, n);
  }

  /** Fills `rate` and `inverseEffectiveMass` for a row that is not locked. */
  look(row: number): void {
    const rows = this.#locked;
    const n = rows.length;
    for (let i = 0; i < n; i++) this.#coupling[i] = this.between(rows[i]!, row);
    forward(this.#factors, this.#coupling, n);
    this.rate = this.rateNow(row);
    this.inverseEffectiveMass = this.between(row, row);
    for (let i = 0; i < n; i++) this.inverseEffectiveMass -= this.#coupling[i]! ** 2;
  }

  /** What gravity and its bodies' steady forces do to the row looked at while the locked rows hold, per second. */
  pull(row: number): number {
    const rows = this.#locked;
    const n = rows.length;
    for (let i = 0; i < n; i++) this.#held[i] = this.#pulled(rows[i]!);
    forward(this.#factors, this.#held, n);
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

  #pulledOn(body: BodyNode | undefined, at: number): number {
    if (!body?.movable) return 0;
    const { force } = this.#world.registry.forces.constant(body);
    const { gravity, mass } = body;
    let sum = 0;
    for (let i = 0; i < 3; i++)
      sum += this.jacobian[at + i]! * (gravity[i]! + force[i]! / mass.mass);
    return sum;
  }

  /** An impulse along the row looked at, as forces for this step; the locked rows hold against it. */
  push(row: number, impulse: number): void {
    const rows = this.#locked;
    const n = rows.length;
    backward(this.#factors, this.#coupling, n);
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

  #apply(body: BodyNode | undefined, at: number): void {
    if (!body?.movable) return;
    const { scratch } = this.#world.engine;
    const [push, dt] = [this.#impulse, this.#dt];
    body.body.applyCentralForce(
      scratch.vector(push[at]! / dt, push[at + 1]! / dt, push[at + 2]! / dt),
    );
    body.body.applyTorque(
      scratch.vector(push[at + 3]! / dt, push[at + 4]! / dt, push[at + 5]! / dt),
    );
  }
}

const ORIGIN = [0, 0, 0, 0, 0, 0, 1];

const still = (body: BodyNode | undefined): boolean => !body?.movable || body.sleeping;
