import type { JointNode } from '../../nodes/joint.js';
import { BODY_BLOCK, ROW_BLOCK, ROWS, SIDE } from './blocks.js';
import type { Component } from './forest.js';
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
 * by the pull of the last step, is added to the inertia that the solver sees: an implicit spring, which damps. What the
 * step can follow is left alone: there the steps keep the energy by themselves (measured: an inertia raised to and fro
 * by the pulls gains 2 % of a double pendulum's in 20 s at 1/120 s).
 */
export class Tension {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  /** What damps: in the inertia that the solver sees, not in the momentum. */
  #damping = new Float64Array(0);
  /** Per joint: the impulse on its first body in the last step. */
  #pulls = new Float64Array(0);
  readonly #arm = new Float64Array(3);

  constructor(system: RowSystem, bodies: JointedBodies) {
    this.#system = system;
    this.#bodies = bodies;
  }

  /** Joints are numbered anew: what pulls in those that were there before goes on. */
  take(before: readonly (JointNode | undefined)[], now: readonly JointNode[]): void {
    const pulls = new Map(before.map((joint, k) => [joint, this.#pulls.slice(k * 3, k * 3 + 3)]));
    if (this.#pulls.length < now.length * 3) this.#pulls = new Float64Array(now.length * 6);
    const none = new Float64Array(3);
    now.forEach((joint, k) => this.#pulls.set(pulls.get(joint) ?? none, k * 3));
    const room = this.#bodies.bodies.length * BODY_BLOCK;
    if (this.#damping.length < room) this.#damping = new Float64Array(2 * room);
  }

  /** How the joint pulls its first body in this step. */
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

  begin({ bodies }: Component): void {
    for (const body of bodies) this.#damping.fill(0, body * BODY_BLOCK, (body + 1) * BODY_BLOCK);
  }

  /** The joint pulls a body at a point, the first one (`sign` 1) or the second. */
  stiffen(joint: number, body: number, point: Float64Array, sign: 1 | -1, dt: number): void {
    if (body < 0) return;
    const arm = this.#arm;
    const { place } = this.#bodies;
    let length2 = 0;
    let outward = 0;
    for (let x = 0; x < 3; x++) {
      arm[x] = point[x]! - place[body * 3 + x]!;
      length2 += arm[x]! * arm[x]!;
      outward += sign * this.#pulls[joint * 3 + x]! * arm[x]!;
    }
    // A push needs no care: it lets go by itself.
    if (!(outward > 0)) return;
    const stiffness = outward * dt;
    const fast = stiffness / (this.#bodies.mass(body) * length2 + this.#bodies.leastMoment(body));
    const lost = 1 - 1 / (1 + (fast / TOO_FAST) ** 4);
    this.#add(body, (stiffness * lost) / length2, length2);
  }

  /** k (r² 1 - r rᵀ) on the turning of a body. */
  #add(body: number, k: number, length2: number): void {
    const to = this.#damping;
    const x = this.#arm[0]!;
    const y = this.#arm[1]!;
    const z = this.#arm[2]!;
    const at = body * BODY_BLOCK + 3 * SIDE + 3;
    to[at]! += k * (length2 - x * x);
    to[at + SIDE]! -= k * x * y;
    to[at + SIDE + 1]! += k * (length2 - y * y);
    to[at + 2 * SIDE]! -= k * x * z;
    to[at + 2 * SIDE + 1]! -= k * y * z;
    to[at + 2 * SIDE + 2]! += k * (length2 - z * z);
  }

  /** Once the momentum is known. */
  damp({ bodies }: Component): void {
    const { inertia } = this.#system;
    for (const body of bodies) {
      const end = (body + 1) * BODY_BLOCK;
      for (let i = body * BODY_BLOCK; i < end; i++) inertia[i]! += this.#damping[i]!;
    }
  }
}
