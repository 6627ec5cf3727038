import type { BodyNode } from '../../nodes/body.js';
import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { BODY_BLOCK, SIDE } from './blocks.js';
import type { Component } from './forest.js';
import { MATRIX, writeMatrix } from './matrix.js';
import type { RowSystem } from './row-system.js';

const POSE = 7;
/** Mass, three moments, gravity, and the shares of linear and angular velocity that damping leaves in a step. */
const TRAITS = 9;

/** Bullet turns no body by more than this in a step, radians. */
const MOST_TURN = Math.PI / 4;

/** The movable bodies that joints hold, in flat arrays of double precision: now, and where the step will take them. */
export class JointedBodies {
  readonly #world: World;
  readonly #system: RowSystem;
  bodies: readonly BodyNode[] = [];
  /** Centres of mass, and principal axes as the columns of a matrix. */
  place = new Float64Array(0);
  turn = new Float64Array(0);
  nextPlace = new Float64Array(0);
  nextTurn = new Float64Array(0);
  /** Linear and angular velocity. */
  velocity = new Float64Array(0);
  /** Force and torque of this step, without gravity. */
  #load = new Float64Array(0);
  #traits = new Float64Array(0);
  /** Bodies that have made their first half step, and the length of their last step, seconds. */
  readonly #lastStep = new Map<BodyNode, number>();
  readonly #pose = new Float64Array(POSE);
  readonly #step = new Float64Array(MATRIX);
  readonly #out = new Float64Array(3);

  constructor(world: World, system: RowSystem) {
    this.#world = world;
    this.#system = system;
  }

  take(bodies: readonly BodyNode[]): void {
    this.bodies = bodies;
    if (this.velocity.length >= bodies.length * SIDE) return;
    const room = bodies.length * 2;
    this.place = new Float64Array(room * 3);
    this.nextPlace = new Float64Array(room * 3);
    this.turn = new Float64Array(room * MATRIX);
    this.nextTurn = new Float64Array(room * MATRIX);
    this.velocity = new Float64Array(room * SIDE);
    this.#load = new Float64Array(room * SIDE);
    this.#traits = new Float64Array(room * TRAITS);
  }

  asleep({ bodies }: Component): boolean {
    for (const i of bodies) if (!this.bodies[i]!.sleeping) return false;
    return true;
  }

  mass(i: number): number {
    return this.#traits[i * TRAITS]!;
  }

  leastMoment(i: number): number {
    const t = i * TRAITS;
    return Math.min(this.#traits[t + 1]!, this.#traits[t + 2]!, this.#traits[t + 3]!);
  }

  lastStep(body: BodyNode): number {
    return this.#lastStep.get(body) ?? 0;
  }

  setLastStep(body: BodyNode, seconds: number): void {
    this.#lastStep.set(body, seconds);
  }

  /** Whether this is the first step of a body. */
  launching(i: number): boolean {
    return i >= 0 && !this.#lastStep.has(this.bodies[i]!);
  }

  /** J v of a row by the velocities before the step. */
  rateNow(joint: number, row: number): number {
    return this.#system.rateBy(this.velocity, joint, row);
  }

  /** Its velocity is given anew, or it begins to move: the next step is a first half step again. */
  relaunch(body: PhysicsNode): boolean {
    return this.#lastStep.delete(body as BodyNode);
  }

  /** Whether what was read last is all finite. */
  finite = true;

  read({ bodies }: Component, dt: number): void {
    let sum = 0;
    for (const i of bodies) {
      this.#readBody(i, this.bodies[i]!, dt);
      for (let x = 0; x < POSE; x++) sum += this.#pose[x]!;
      for (let x = i * SIDE; x < (i + 1) * SIDE; x++) sum += this.velocity[x]!;
    }
    this.finite = Number.isFinite(sum);
  }

  #readBody(i: number, body: BodyNode, dt: number): void {
    const { reader } = this.#world.engine;
    reader.pose(body.body, body.pointer, this.#pose, 0);
    reader.velocity(body.body, body.pointer, this.velocity, i * SIDE);
    reader.load(body.body, body.pointer, this.#load, i * SIDE);
    for (let x = 0; x < 3; x++) this.place[i * 3 + x] = this.#pose[x]!;
    writeMatrix(this.turn, i * MATRIX, this.#pose, 3);
    const t = i * TRAITS;
    const { mass, moments } = body.mass;
    this.#traits[t] = mass;
    for (let x = 0; x < 3; x++) {
      this.#traits[t + 1 + x] = moments[x]!;
      this.#traits[t + 4 + x] = body.gravity[x]!;
    }
    this.#traits[t + 7] = (1 - body.dampedShare.linear) ** dt;
    this.#traits[t + 8] = (1 - body.dampedShare.angular) ** dt;
    this.#writeInertia(i, mass, moments);
  }

  #writeInertia(i: number, mass: number, moments: readonly number[]): void {
    const { inertia } = this.#system;
    const at = i * BODY_BLOCK;
    const o = i * MATRIX;
    const m = this.turn;
    inertia.fill(0, at, at + BODY_BLOCK);
    inertia[at] = inertia[at + 7] = inertia[at + 14] = mass;
    for (let r = 0; r < 3; r++) {
      for (let c = 0; c <= r; c++) {
        let sum = 0;
        for (let k = 0; k < 3; k++) sum += m[o + r * 3 + k]! * moments[k]! * m[o + c * 3 + k]!;
        inertia[at + (r + 3) * SIDE + 3 + c] = sum;
      }
    }
  }
  /**
   * What the joints are to bring to their velocities: momentum now, with the damping and the forces from the middle of
   * the last step to that of this one. In its first step a body gets half of them: velocities then belong to the middle
   * of each step, which makes the motion of joints second order in the step (measured: 1 to 2 orders of magnitude less
   * error, for nothing). After a change of level the two steps differ.
   */
  writeMomentum({ bodies }: Component, dt: number): void {
    for (const i of bodies) {
      const body = this.bodies[i]!;
      this.#writeMomentum(i, (this.lastStep(body) + dt) / 2);
      this.#lastStep.set(body, dt);
    }
  }

  #writeMomentum(i: number, dt: number): void {
    const { inertia, momentum } = this.#system;
    const traits = this.#traits;
    const p = i * SIDE;
    const t = i * TRAITS;
    const b = i * BODY_BLOCK + 21;
    const load = this.#load;
    const v = this.velocity;
    const linear = traits[t + 7]!;
    const angular = traits[t + 8]!;
    for (let x = 0; x < 3; x++)
      momentum[p + x] =
        traits[t]! * (v[p + x]! * linear + dt * traits[t + 4 + x]!) + dt * load[p + x]!;
    const x = v[p + 3]! * angular;
    const y = v[p + 4]! * angular;
    const z = v[p + 5]! * angular;
    momentum[p + 3] =
      inertia[b]! * x + inertia[b + 6]! * y + inertia[b + 12]! * z + dt * load[p + 3]!;
    momentum[p + 4] =
      inertia[b + 6]! * x + inertia[b + 7]! * y + inertia[b + 13]! * z + dt * load[p + 4]!;
    momentum[p + 5] =
      inertia[b + 12]! * x + inertia[b + 13]! * y + inertia[b + 14]! * z + dt * load[p + 5]!;
  }

  /** Where the velocities found will take the bodies, as Bullet will turn them. */
  predict({ bodies }: Component, dt: number): void {
    const { velocity } = this.#system;
    for (const i of bodies) {
      for (let x = 0; x < 3; x++)
        this.nextPlace[i * 3 + x] = this.place[i * 3 + x]! + dt * velocity[i * SIDE + x]!;
      this.#turnOn(i, velocity, i * SIDE + 3, dt);
    }
  }

  #turnOn(i: number, velocity: Float64Array, at: number, dt: number): void {
    const speed = Math.hypot(velocity[at]!, velocity[at + 1]!, velocity[at + 2]!);
    const angle = Math.min(speed * dt, MOST_TURN);
    const s = speed > 1e-12 ? Math.sin(angle / 2) / speed : dt / 2;
    for (let x = 0; x < 3; x++) this.#pose[x] = velocity[at + x]! * s;
    this.#pose[3] = Math.cos(angle / 2);
    writeMatrix(this.#step, 0, this.#pose, 0);
    const o = i * MATRIX;
    for (let r = 0; r < 3; r++) {
      for (let c = 0; c < 3; c++) {
        let sum = 0;
        for (let k = 0; k < 3; k++) sum += this.#step[r * 3 + k]! * this.turn[o + k * 3 + c]!;
        this.nextTurn[o + r * 3 + c] = sum;
      }
    }
  }

  /** Whether the velocities found are finite. */
  sane({ bodies }: Component): boolean {
    const { velocity } = this.#system;
    let sum = 0;
    for (const i of bodies) for (let x = i * SIDE; x < (i + 1) * SIDE; x++) sum += velocity[x]!;
    return Number.isFinite(sum);
  }

  /** Gives the velocities found to Bullet, less what Bullet itself will add in this step. */
  write({ bodies }: Component, dt: number): void {
    for (const i of bodies) this.#writeBody(i, this.bodies[i]!, dt);
  }

  #writeBody(i: number, { body }: BodyNode, dt: number): void {
    const { velocity } = this.#system;
    const { scratch } = this.#world.engine;
    const v = i * SIDE;
    const t = i * TRAITS;
    const load = this.#load;
    const out = this.#out;
    for (let x = 0; x < 3; x++)
      out[x] =
        (velocity[v + x]! - dt * (this.#traits[t + 4 + x]! + load[v + x]! / this.#traits[t]!)) /
        this.#traits[t + 7]!;
    body.setLinearVelocity(scratch.vector(out[0]!, out[1]!, out[2]!));
    const o = i * MATRIX;
    const m = this.turn;
    for (let x = 0; x < 3; x++) out[x] = velocity[v + 3 + x]!;
    if (load[v + 3] !== 0 || load[v + 4] !== 0 || load[v + 5] !== 0) {
      for (let k = 0; k < 3; k++) {
        const along =
          m[o + k]! * load[v + 3]! + m[o + 3 + k]! * load[v + 4]! + m[o + 6 + k]! * load[v + 5]!;
        const change = (dt * along) / this.#traits[t + 1 + k]!;
        for (let x = 0; x < 3; x++) out[x]! -= change * m[o + x * 3 + k]!;
      }
    }
    const damped = this.#traits[t + 8]!;
    body.setAngularVelocity(scratch.vector(out[0]! / damped, out[1]! / damped, out[2]! / damped));
  }
}
