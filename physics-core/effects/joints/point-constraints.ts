import type { Joint } from '../../dynamics/joint.js';
import { compose, subtract } from '../../base/math.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Edge, Forest } from '../../solver/joints/forest.js';
import type { Ways } from './joint-ends.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { NextPoses } from './next-poses.js';
import type { PointSolver } from '../../solver/joints/point-solver.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/** Numbers of both points of a pin; the parent's begins half-way. */
const POINTS = 6;
const PARENT = 3;

/** Whether a joint holds a point of one body at a point of the other, hard. */
export const isPin = ({ corrections, limits }: Joint): boolean =>
  [0, 1, 2].every(
    (row) =>
      limits[row]![0] === limits[row]![1] &&
      Math.abs(limits[row]![0]) < Number.EPSILON &&
      corrections[row]!.softness === 0 &&
      corrections[row]!.erp === corrections[0]!.erp,
  );

/** Where the points of pins are and at what rate they are to come together: for pins what `LockedRows` is for rows. */
export class PointConstraints {
  readonly #system: RowSystem;
  readonly #pins: PointSolver;
  readonly #bodies: JointedBodies;
  readonly #next: NextPoses;
  #forest!: Forest;
  /** Both points from the centres of mass of child and parent, in their bodies; in the world if that holds it. */
  #points = new Float64Array(0);
  /** On what way the step takes the parent's point, where a carried body holds it. */
  #ways = new Float64Array(0);
  /** Share of an error repaired per step. */
  #erps = new Float64Array(0);
  /** From the parent's point to the child's at the start of the step. */
  #errors = new Float64Array(0);
  /** What `correct` asked for in the last step: the round ways of the next one are nearly the same. */
  #nonlinearCorrections = new Float64Array(0);
  readonly #apart = new Float64Array(3);
  /** Both points from the centres of mass as the bodies are turned now; those at which they pull may lean. */
  #arms = new Float64Array(0);
  /** On what way the last step took the parent's point; of joints numbered anew nobody knows. */
  #lastWays = new Float64Array(0);

  constructor(system: RowSystem, bodies: JointedBodies, next: NextPoses) {
    this.#system = system;
    this.#pins = system.pins;
    this.#bodies = bodies;
    this.#next = next;
  }

  take(joints: readonly Joint[], edges: readonly Edge[], forest: Forest): void {
    this.#forest = forest;
    if (this.#erps.length < joints.length) this.#grow(joints.length * 2);
    this.#nonlinearCorrections.fill(0);
    this.#lastWays.fill(NaN);
    for (const { pins } of forest.components)
      for (const pin of pins) this.takePoints(pin, joints[pin]!, edges[pin]!);
  }

  takePoints(pin: number, joint: Joint, { a, b }: Edge, ways?: Ways): void {
    const one = a < 0 ? joint.frameInBullet(1) : joint.centred1;
    const two = b < 0 ? joint.frameInBullet(2) : joint.centred2;
    const childIsFirst = this.#forest.childOf[pin] === a;
    this.#points.set((childIsFirst ? one : two).p, pin * POINTS);
    this.#points.set((childIsFirst ? two : one).p, pin * POINTS + PARENT);
    this.#erps[pin] = joint.corrections[0]!.erp;
    this.#ways.fill(0, pin * 3, pin * 3 + 3);
    const way = childIsFirst ? ways?.two : ways?.one;
    if (!way) return;
    const frame = childIsFirst ? joint.centred2 : joint.centred1;
    const from = compose(way.now, frame).p;
    const to = compose(way.next, frame).p;
    this.#points.set(from, pin * POINTS + PARENT);
    this.#ways.set(subtract(to, from), pin * 3);
  }

  /** What the next step asks of the last one: three numbers of each. */
  get lasting(): readonly Float64Array[] {
    return [this.#nonlinearCorrections, this.#lastWays];
  }

  #grow(room: number): void {
    this.#points = new Float64Array(room * POINTS);
    this.#arms = new Float64Array(room * POINTS);
    this.#ways = new Float64Array(room * 3);
    this.#lastWays = new Float64Array(room * 3);
    this.#erps = new Float64Array(room);
    this.#errors = new Float64Array(room * 3);
    this.#nonlinearCorrections = new Float64Array(room * 3);
  }

  // ---- a step -------------------------------------------------------------------------------------------------------

  /** Its points where the step begins; returns the worst error, metres. */
  fill(pin: number): number {
    const arms = this.#arms;
    const { place } = this.#bodies;
    const e = pin * 3;
    const at = pin * POINTS;
    const child = this.#forest.childOf[pin]!;
    const parent = this.#forest.parentOf[child]!;
    const points = this.#points;
    this.#bodies.turned(child, points, at, arms, at);
    let x = place[child * 3]! + arms[at]!;
    let y = place[child * 3 + 1]! + arms[at + 1]!;
    let z = place[child * 3 + 2]! + arms[at + 2]!;
    const o = at + PARENT;
    if (parent < 0) {
      x -= points[o]!;
      y -= points[o + 1]!;
      z -= points[o + 2]!;
    } else {
      this.#bodies.turned(parent, points, o, arms, o);
      x -= place[parent * 3]! + arms[o]!;
      y -= place[parent * 3 + 1]! + arms[o + 1]!;
      z -= place[parent * 3 + 2]! + arms[o + 2]!;
    }
    for (let i = at; i < at + POINTS; i++) this.#pins.factors.arms[i] = arms[i]!;
    this.#errors[e] = x;
    this.#errors[e + 1] = y;
    this.#errors[e + 2] = z;
    return Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  }

  /** Asks for nothing but that it be shaken: for the change of its point's velocity. False: there is none. */
  setShaking(pin: number, dt: number): boolean {
    const { targetVelocity } = this.#pins;
    const at = pin * 3;
    let any = false;
    for (let i = at; i < at + 3; i++) {
      const change = this.#ways[i]! - this.#lastWays[i]!;
      this.#lastWays[i] = this.#ways[i]!;
      targetVelocity[i] = Number.isNaN(change) ? 0 : change / dt;
      any ||= targetVelocity[i] !== 0;
    }
    return any;
  }

  /** Has it pull as if its bodies were turned by the velocities found times `dt`. */
  lean(pin: number, dt: number): void {
    const child = this.#forest.childOf[pin]!;
    const parent = this.#forest.parentOf[child]!;
    this.#lean(pin * POINTS, child, dt);
    if (parent >= 0) this.#lean(pin * POINTS + PARENT, parent, dt);
  }

  #lean(at: number, body: number, dt: number): void {
    const { velocity, pins } = this.#system;
    const spin = body * SIDE + 3;
    const x = velocity[spin]! * dt;
    const y = velocity[spin + 1]! * dt;
    const z = velocity[spin + 2]! * dt;
    const a = this.#arms[at]!;
    const b = this.#arms[at + 1]!;
    const c = this.#arms[at + 2]!;
    pins.factors.arms[at] = a + y * c - z * b;
    pins.factors.arms[at + 1] = b + z * a - x * c;
    pins.factors.arms[at + 2] = c + x * b - y * a;
  }

  /** The rate at which the points are to come together; `repair` 0 leaves them apart as they are. */
  setTargets(pin: number, dt: number, repair: 0 | 1): void {
    const { targetVelocity } = this.#pins;
    const rate = (-repair * this.#erps[pin]!) / dt;
    if (repair === 0) this.forgetCorrections(pin);
    for (let i = pin * 3; i < pin * 3 + 3; i++)
      targetVelocity[i] =
        rate * this.#errors[i]! + this.#nonlinearCorrections[i]! + this.#ways[i]! / dt;
  }

  /** Forgets what round ways asked for. */
  forgetCorrections(pin: number): void {
    this.#nonlinearCorrections.fill(0, pin * 3, pin * 3 + 3);
  }

  /** For a solution in ways instead of velocities: the points come together. */
  setWholeTargets(pin: number): void {
    const { targetVelocity } = this.#pins;
    for (let i = pin * 3; i < pin * 3 + 3; i++) targetVelocity[i] = -this.#errors[i]!;
  }

  /** As that of `LockedRows`. Returns by how much the step would miss, metres. */
  correct(pin: number, dt: number, repair: 0 | 1): number {
    const { targetVelocity } = this.#pins;
    const arms = this.#arms;
    const child = this.#forest.childOf[pin]!;
    const parent = this.#forest.parentOf[child]!;
    const apart = this.#apart;
    const erp = repair * this.#erps[pin]!;
    const e = pin * 3;
    // What is left of the error now, less what shall be left.
    for (let x = 0; x < 3; x++) apart[x] = erp * this.#errors[e + x]! - this.#ways[e + x]!;
    this.#next.addDisplacement(child, arms, pin * POINTS, dt, 1, apart);
    if (parent >= 0) this.#next.addDisplacement(parent, arms, pin * POINTS + PARENT, dt, -1, apart);
    for (let x = 0; x < 3; x++) {
      targetVelocity[e + x]! -= apart[x]! / dt;
      this.#nonlinearCorrections[e + x]! -= apart[x]! / dt;
    }
    return Math.max(Math.abs(apart[0]!), Math.abs(apart[1]!), Math.abs(apart[2]!));
  }
}
