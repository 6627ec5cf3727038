import type { Joint } from '../../dynamics/joint.js';
import { INERTIA, ROW_BLOCK, ROWS, SIDE } from './blocks.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from './row-system.js';

/**
 * Stiffness from which on the motion is too fast for the step and is damped instead: in squares of radians per step
 * (measured: at 0.4 a chain of 100 links cracks like a whip without tearing; 1:1000 chains still swing as they should).
 */
const TOO_FAST = 0.4;

/**
 * A pulled joint swings its bodies about it like the string of an instrument, faster the harder it is pulled. What
 * swings faster than the steps can follow would gain energy until it tears. Where the step can't follow, its stiffness,
 * by the pull of the last step, is added to the inertia that the solver sees, and not to the momentum: an implicit spring,
 * which damps. What the step can follow is left alone: there the steps keep the energy by themselves (measured: an
 * inertia raised to and fro by the pulls gains 2 % of a double pendulum's in 20 s at 1/120 s).
 */
export class GeometricStiffness {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  /** Per joint: the impulse on its first body in the last step. */
  #pulls = new Float64Array(0);
  readonly #arm = new Float64Array(3);

  constructor(system: RowSystem, bodies: JointedBodies) {
    this.#system = system;
    this.#bodies = bodies;
  }

  /** Joints are numbered anew: what pulls in those that were there before goes on. */
  take(before: readonly (Joint | undefined)[], now: readonly Joint[]): void {
    const pulls = new Map(before.map((joint, k) => [joint, this.#pulls.slice(k * 3, k * 3 + 3)]));
    if (this.#pulls.length < now.length * 3) this.#pulls = new Float64Array(now.length * 6);
    const none = new Float64Array(3);
    now.forEach((joint, k) => this.#pulls.set(pulls.get(joint) ?? none, k * 3));
  }

  /** How a joint of rows pulls its first body in this step. */
  note(joint: number): void {
    const { jacobian, impulse, rowCount } = this.#system;
    const p = joint * 3;
    this.#pulls.fill(0, p, p + 3);
    for (let r = 0; r < rowCount[joint]!; r++) {
      const at = joint * 2 * ROW_BLOCK + r * SIDE;
      for (let x = 0; x < 3; x++)
        this.#pulls[p + x]! += jacobian[at + x]! * impulse[joint * ROWS + r]!;
    }
  }

  /** The same of a pin. */
  notePin(pin: number): void {
    const { pins, forest, velocity } = this.#system;
    const child = forest.childOf[pin]!;
    const sign = this.#signOf(pin, child);
    pins.pull(pin, velocity, forest.parentOf[child]!, this.#pulls, pin * 3, sign);
  }

  #signOf(joint: number, body: number): 1 | -1 {
    return this.#system.edges[joint]!.a === body ? 1 : -1;
  }

  /** The joint pulls both its bodies at a point. */
  stiffen(joint: number, point: Float64Array, dt: number): void {
    const { a, b } = this.#system.edges[joint]!;
    this.#stiffenAt(joint, a, point, 1, dt);
    this.#stiffenAt(joint, b, point, -1, dt);
  }

  #stiffenAt(joint: number, body: number, point: Float64Array, sign: 1 | -1, dt: number): void {
    if (body < 0) return;
    const { place } = this.#bodies;
    for (let x = 0; x < 3; x++) this.#arm[x] = point[x]! - place[body * 3 + x]!;
    this.#stiffen(joint, body, this.#arm, 0, sign, dt);
  }

  stiffenPin(pin: number, dt: number): void {
    const { pins, forest } = this.#system;
    const child = forest.childOf[pin]!;
    const parent = forest.parentOf[child]!;
    const sign = this.#signOf(pin, child);
    this.#stiffen(pin, child, pins.factors.arms, pin * SIDE, sign, dt);
    if (parent >= 0)
      this.#stiffen(pin, parent, pins.factors.arms, pin * SIDE + 3, sign === 1 ? -1 : 1, dt);
  }

  /**
   * At the end of an arm of the body, which is the joint's first one (`sign` 1) or its second. What counts of the arm lies
   * along the pull: of two joints that hold a wide plank side by side the rest cancels out, but each by itself would look
   * as if the plank could hardly swing (with all of the arm a bridge of forty planks between two posts tore within a second).
   */
  #stiffen(
    joint: number,
    body: number,
    arms: Float64Array,
    at: number,
    sign: 1 | -1,
    dt: number,
  ): void {
    const pulls = this.#pulls;
    const x = arms[at]!;
    const y = arms[at + 1]!;
    const z = arms[at + 2]!;
    const p = joint * 3;
    const fx = pulls[p]!;
    const fy = pulls[p + 1]!;
    const fz = pulls[p + 2]!;
    const outward = sign * (fx * x + fy * y + fz * z);
    // A push needs no care: it lets go by itself.
    if (!(outward > 0)) return;
    const pull2 = fx * fx + fy * fy + fz * fz;
    const arm2 = (outward * outward) / pull2;
    const stiffness = outward * dt;
    const fast = stiffness / (this.#bodies.mass(body) * arm2 + this.#bodies.leastMoment(body));
    const square = (fast / TOO_FAST) ** 2;
    const lost = 1 - 1 / (1 + square * square);
    const k = (stiffness * lost) / pull2;
    // k (f² 1 - f fᵀ) on the turning of the body.
    const { inertia } = this.#system;
    const to = body * INERTIA + 1;
    inertia[to]! += k * (pull2 - fx * fx);
    inertia[to + 1]! -= k * fx * fy;
    inertia[to + 2]! += k * (pull2 - fy * fy);
    inertia[to + 3]! -= k * fx * fz;
    inertia[to + 4]! -= k * fy * fz;
    inertia[to + 5]! += k * (pull2 - fz * fz);
  }
}
