import type { Body } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { dot3 } from '../../base/flat-math.js';
import { copy6, INERTIA, SIDE } from '../../solver/joints/blocks.js';
import type { Component } from '../../solver/joints/forest.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/** Of a body: mass, three moments, and the shares of linear and angular velocity that damping leaves in a step. */
const TRAITS = 6;
const MOMENTS = 1;
const DAMPED = 4;

/** A step in which the joint solve moved a body: its number, and its length in seconds. */
interface Moved {
  step: number;
  seconds: number;
}

/** The movable bodies that joints hold, in flat arrays of double precision. */
export class JointedBodies {
  readonly #simulation: Simulation;
  readonly #system: RowSystem;
  bodies: readonly Body[] = [];
  /** Centres of mass, and principal axes as the columns of a matrix. */
  place = new Float64Array(0);
  turn = new Float64Array(0);
  /** Linear and angular velocity. */
  velocity = new Float64Array(0);
  /** Force and torque of this step, without gravity. */
  #load = new Float64Array(0);
  #traits = new Float64Array(0);
  /** Bodies that have made their first half step, and the last one. */
  readonly #moved = new Map<Body, Moved>();
  readonly #pose = new Float64Array(POSE);
  readonly #out = new Float64Array(SIDE);

  /** Whose bodies these are, at the end of their last step. */
  readonly #of: JointedBodies | undefined;

  constructor(simulation: Simulation, system: RowSystem, of?: JointedBodies) {
    this.#simulation = simulation;
    this.#system = system;
    this.#of = of;
  }

  take(bodies: readonly Body[]): void {
    this.bodies = bodies;
    if (this.velocity.length >= bodies.length * SIDE) return;
    const room = bodies.length * 2;
    this.place = new Float64Array(room * 3);
    this.turn = new Float64Array(room * MATRIX);
    this.velocity = new Float64Array(room * SIDE);
    this.#load = new Float64Array(room * SIDE);
    this.#traits = new Float64Array(room * TRAITS);
  }

  asleep({ bodies }: Component): boolean {
    for (const i of bodies) if (!this.#simulation.bodies.asleep(this.bodies[i]!)) return false;
    return true;
  }

  /** Whether all of it are awake. */
  awake({ bodies }: Component): boolean {
    for (const i of bodies) if (this.#simulation.bodies.asleep(this.bodies[i]!)) return false;
    return true;
  }

  /** Whether Bullet has woken any of them in its step: something awake touches it. */
  woken({ bodies }: Component): boolean {
    const { reader } = this.#simulation.engine;
    for (const i of bodies) {
      const { pointer } = this.bodies[i]!;
      if (!reader.sleeps(pointer)) return true;
    }
    return false;
  }

  mass(i: number): number {
    return this.#traits[i * TRAITS]!;
  }

  moment(i: number, axis: number): number {
    return this.#traits[i * TRAITS + MOMENTS + axis]!;
  }

  /** The spin of a velocity about a principal axis, a column of `turn`. */
  along(v: Float64Array, at: number, axis: number): number {
    const m = this.turn;
    return v[at + 3]! * m[axis]! + v[at + 4]! * m[axis + 3]! + v[at + 5]! * m[axis + 6]!;
  }

  leastMoment(i: number): number {
    const t = i * TRAITS + MOMENTS;
    return Math.min(this.#traits[t]!, this.#traits[t + 1]!, this.#traits[t + 2]!);
  }

  // ---- the first step -------------------------------------------------------------------------------------------------

  /** Seconds of its last step; 0 before its first. A step without the joint solve leaves a velocity of that moment. */
  lastStep(body: Body): number {
    const moved = this.#moved.get(body);
    return moved && moved.step >= this.#simulation.stepsTaken ? moved.seconds : 0;
  }

  /** Of a component at the end of its step: the longest of its bodies. */
  stepOf({ bodies }: Component): number {
    let longest = 0;
    for (const i of bodies) longest = Math.max(longest, this.#of!.lastStep(this.bodies[i]!));
    return longest;
  }

  eachMoved(visit: (body: Body) => void): void {
    for (const body of this.#moved.keys()) visit(body);
  }

  forgetSteps(): void {
    this.#moved.clear();
  }

  /** Ids, and each step with its seconds. */
  keepSteps(): [id: number, step: number, seconds: number][] {
    return [...this.#moved].map(([{ id }, { step, seconds }]) => [id, step, seconds]);
  }

  /** Ids, and what pushed each in its last step: six numbers. */
  keepLoads(): [id: number, load: Float64Array][] {
    const loads = this.bodies.map(({ id }, i): [number, Float64Array] => [id, this.#loadOf(i)]);
    return loads.filter(([, load]) => load.some(Boolean));
  }

  setLoad(body: Body, load: Float64Array): void {
    const i = this.bodies.indexOf(body);
    if (i >= 0) this.#loadOf(i).set(load);
  }

  #loadOf(i: number): Float64Array {
    return this.#load.subarray(i * SIDE, (i + 1) * SIDE);
  }

  goOn(body: Body, step: number, seconds: number): void {
    this.#note(body, step, seconds);
  }

  /** Its velocity is given anew, or it begins to move: the next step is a first half step again. */
  relaunch(body: Body): void {
    this.#moved.delete(body);
  }

  /** Whether this is the first step of a body. */
  launching(i: number): boolean {
    return i >= 0 && this.lastStep(this.bodies[i]!) === 0;
  }

  /** The step that begins. */
  noteStep({ bodies }: Component, dt: number): void {
    for (const i of bodies) this.#note(this.bodies[i]!, this.#simulation.stepsTaken + 1, dt);
  }

  #note(body: Body, step: number, seconds: number): void {
    const moved = this.#moved.get(body);
    if (!moved) this.#moved.set(body, { step, seconds });
    else {
      moved.step = step;
      moved.seconds = seconds;
    }
  }

  // ---- before a step --------------------------------------------------------------------------------------------------

  /** Whether what was read last is all finite. */
  finite = true;

  read(component: Component, dt: number): void {
    this.readInertia(component, dt);
    for (const i of component.bodies) this.#writeMomentum(i, this.bodies[i]!, dt);
  }

  /** All but what joints are to bring to their velocities. */
  readInertia({ bodies }: Component, dt: number): void {
    let sum = 0;
    for (const i of bodies) sum += this.#read(i, this.bodies[i]!, dt);
    this.finite = Number.isFinite(sum);
  }

  /** Returns what is finite only if all that was read is. */
  #read(i: number, node: Body, dt: number): number {
    const { reader } = this.#simulation.engine;
    const { pointer } = node;
    const pose = this.#pose;
    const v = this.velocity;
    const p = i * SIDE;
    reader.pose(pointer, pose, 0);
    reader.velocity(pointer, v, p);
    if (this.#of) copy6(this.#load, p, this.#of.#load, p);
    else reader.load(pointer, this.#load, p);
    this.place[i * 3] = pose[0]!;
    this.place[i * 3 + 1] = pose[1]!;
    this.place[i * 3 + 2] = pose[2]!;
    writeMatrix(this.turn, i * MATRIX, pose, 3);
    this.#readTraits(i, node, this.#of ? this.#of.lastStep(node) / 2 : dt);
    this.#writeInertia(i);
    return (
      pose[0]! +
      pose[1]! +
      pose[2]! +
      pose[3]! +
      pose[4]! +
      pose[5]! +
      pose[6]! +
      v[p]! +
      v[p + 1]! +
      v[p + 2]! +
      v[p + 3]! +
      v[p + 4]! +
      v[p + 5]!
    );
  }

  #readTraits(i: number, { mass: { mass, moments }, dampedShare }: Body, dt: number): void {
    const traits = this.#traits;
    const t = i * TRAITS;
    traits[t] = mass;
    traits[t + MOMENTS] = moments[0];
    traits[t + MOMENTS + 1] = moments[1];
    traits[t + MOMENTS + 2] = moments[2];
    const { linear, angular } = dampedShare;
    traits[t + DAMPED] = linear === 0 ? 1 : (1 - linear) ** dt;
    traits[t + DAMPED + 1] = angular === 0 ? 1 : (1 - angular) ** dt;
  }

  #writeInertia(i: number): void {
    const { inertia } = this.#system;
    const m = this.turn;
    const o = i * MATRIX;
    const t = i * TRAITS + MOMENTS;
    let at = i * INERTIA;
    inertia[at++] = this.#traits[i * TRAITS]!;
    for (let r = o; r < o + MATRIX; r += 3) {
      const x = m[r]! * this.#traits[t]!;
      const y = m[r + 1]! * this.#traits[t + 1]!;
      const z = m[r + 2]! * this.#traits[t + 2]!;
      for (let c = o; c <= r; c += 3) inertia[at++] = x * m[c]! + y * m[c + 1]! + z * m[c + 2]!;
    }
  }

  /**
   * What the joints are to bring to their velocities: momentum now, with the damping and the forces from the middle of
   * the last step to that of this one. In its first step a body gets half of them: velocities then belong to the middle
   * of each step, which makes the motion of joints second order in the step (measured: 1 to 2 orders of magnitude less
   * error, for nothing). After a change of level the two steps differ.
   */
  #writeMomentum(i: number, node: Body, step: number): void {
    const { inertia, momentum } = this.#system;
    const dt = this.#of ? this.#of.lastStep(node) / 2 : (this.lastStep(node) + step) / 2;
    const { appliedGravity } = node;
    const t = i * TRAITS;
    const n = i * INERTIA;
    const p = i * SIDE;
    const v = this.velocity;
    const load = this.#load;
    const mass = this.#traits[t]!;
    const linear = this.#traits[t + DAMPED]!;
    const angular = this.#traits[t + DAMPED + 1]!;
    momentum[p] = mass * (v[p]! * linear + dt * appliedGravity[0]) + dt * load[p]!;
    momentum[p + 1] = mass * (v[p + 1]! * linear + dt * appliedGravity[1]) + dt * load[p + 1]!;
    momentum[p + 2] = mass * (v[p + 2]! * linear + dt * appliedGravity[2]) + dt * load[p + 2]!;
    const x = v[p + 3]! * angular;
    const y = v[p + 4]! * angular;
    const z = v[p + 5]! * angular;
    const yx = inertia[n + 2]!;
    const zx = inertia[n + 4]!;
    const zy = inertia[n + 5]!;
    momentum[p + 3] = inertia[n + 1]! * x + yx * y + zx * z + dt * load[p + 3]!;
    momentum[p + 4] = yx * x + inertia[n + 3]! * y + zy * z + dt * load[p + 4]!;
    momentum[p + 5] = zx * x + zy * y + inertia[n + 6]! * z + dt * load[p + 5]!;
  }

  /** In the middle of a step: as contacts left them, and with what pushed them aside if that is to go on for `dt` seconds. */
  readMomentum({ bodies }: Component, dt: number): void {
    const { reader } = this.#simulation.engine;
    const v = this.#out;
    const pose = this.#pose;
    for (const i of bodies) {
      const { pointer } = this.bodies[i]!;
      reader.velocity(pointer, v, 0);
      if (dt > 0) {
        reader.pose(pointer, pose, 0);
        for (let x = 0; x < 3; x++) v[x]! += (pose[x]! - this.place[i * 3 + x]!) / dt;
      }
      this.#writeMomentumOf(i, v);
    }
  }

  #writeMomentumOf(i: number, v: Float64Array): void {
    const { inertia, momentum } = this.#system;
    const n = i * INERTIA;
    const p = i * SIDE;
    for (let x = 0; x < 3; x++) momentum[p + x] = inertia[n]! * v[x]!;
    const x = v[3]!;
    const y = v[4]!;
    const z = v[5]!;
    const yx = inertia[n + 2]!;
    const zx = inertia[n + 4]!;
    const zy = inertia[n + 5]!;
    momentum[p + 3] = inertia[n + 1]! * x + yx * y + zx * z;
    momentum[p + 4] = yx * x + inertia[n + 3]! * y + zy * z;
    momentum[p + 5] = zx * x + zy * y + inertia[n + 6]! * z;
  }

  /** J v of a row by the velocities before the step. */
  rateNow(joint: number, row: number): number {
    return this.#system.rateBy(this.velocity, joint, row);
  }

  /** A vector of the body as the body is turned now. */
  turned(i: number, from: Float64Array, at: number, to: Float64Array, into: number): void {
    const m = this.turn;
    const o = i * MATRIX;
    const x = from[at]!;
    const y = from[at + 1]!;
    const z = from[at + 2]!;
    to[into] = m[o]! * x + m[o + 1]! * y + m[o + 2]! * z;
    to[into + 1] = m[o + 3]! * x + m[o + 4]! * y + m[o + 5]! * z;
    to[into + 2] = m[o + 6]! * x + m[o + 7]! * y + m[o + 8]! * z;
  }

  // ---- after the solution ---------------------------------------------------------------------------------------------

  /** Whether the velocities found are finite. */
  sane({ bodies }: Component): boolean {
    const { velocity } = this.#system;
    let sum = 0;
    for (const i of bodies) for (let x = i * SIDE; x < (i + 1) * SIDE; x++) sum += velocity[x]!;
    return Number.isFinite(sum);
  }

  /** Of the velocities found, the greatest speed, m/s. */
  fastestOf({ bodies }: Component): number {
    const { velocity } = this.#system;
    let square = 0;
    for (const i of bodies) square = Math.max(square, dot3(velocity, i * SIDE, velocity, i * SIDE));
    return Math.sqrt(square);
  }

  /** Gives the velocities found to Bullet, less what Bullet itself will add in this step. */
  write({ bodies }: Component, dt: number): void {
    for (const i of bodies) this.#write(i, this.bodies[i]!, dt);
  }

  #write(i: number, { pointer, appliedGravity }: Body, dt: number): void {
    const { velocity } = this.#system;
    const v = i * SIDE;
    const t = i * TRAITS;
    const load = this.#load;
    const out = this.#out;
    const mass = this.#traits[t]!;
    const linear = this.#traits[t + DAMPED]!;
    const angular = this.#traits[t + DAMPED + 1]!;
    out[0] = (velocity[v]! - dt * (appliedGravity[0] + load[v]! / mass)) / linear;
    out[1] = (velocity[v + 1]! - dt * (appliedGravity[1] + load[v + 1]! / mass)) / linear;
    out[2] = (velocity[v + 2]! - dt * (appliedGravity[2] + load[v + 2]! / mass)) / linear;
    for (let x = 3; x < SIDE; x++) out[x] = velocity[v + x]!;
    if (load[v + 3] !== 0 || load[v + 4] !== 0 || load[v + 5] !== 0) this.#leaveTorque(i, dt);
    for (let x = 3; x < SIDE; x++) out[x]! /= angular;
    this.#simulation.engine.velocities.write(pointer, out, 0);
  }

  /** Bullet will add what the torque of this step does. */
  #leaveTorque(i: number, dt: number): void {
    const out = this.#out;
    const m = this.turn;
    const o = i * MATRIX;
    const v = i * SIDE + 3;
    const t = this.#load;
    for (let k = 0; k < 3; k++) {
      const along = m[o + k]! * t[v]! + m[o + 3 + k]! * t[v + 1]! + m[o + 6 + k]! * t[v + 2]!;
      const change = (dt * along) / this.#traits[i * TRAITS + MOMENTS + k]!;
      for (let x = 0; x < 3; x++) out[3 + x]! -= change * m[o + x * 3 + k]!;
    }
  }
}
