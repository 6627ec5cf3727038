import { hypot } from '../../base/exact/index.js';
import { dot3 } from '../../base/flat-math.js';
import type { Joint } from '../../dynamics/joint.js';
import { INERTIA, ROW_BLOCK, ROWS, SIDE } from '../../solver/joints/blocks.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/**
 * Stiffness from which on the motion is too fast for the step and is damped instead: in squares of radians per step
 * (measured: at 0.4 a chain of 100 links cracks like a whip without tearing; 1:1000 chains still swing as they should).
 */
const TOO_FAST = 0.4;

/** Joints that hold the same two bodies together: a door on two hinges, a plank on two ropes. */
interface Pair {
  readonly joints: number;
  /** Those of them that were seen in this step: what they pull the first body by, and where, weighed by how hard. */
  seen: number;
  weight: number;
  readonly pull: Float64Array;
  readonly point: Float64Array;
}

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
  /** By joint, of those that are not the only ones to hold their bodies together. */
  readonly #pairs = new Map<number, Pair>();

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
    this.#findPairs();
  }

  #findPairs(): void {
    const all = new Map<string, number[]>();
    this.#system.edges.forEach(({ a, b }, joint) => {
      const bodies = a < b ? `${a} ${b}` : `${b} ${a}`;
      all.set(bodies, [...(all.get(bodies) ?? []), joint]);
    });
    this.#pairs.clear();
    for (const joints of all.values()) {
      if (joints.length === 1) continue;
      const pull = new Float64Array(3);
      const point = new Float64Array(3);
      const pair = { joints: joints.length, seen: 0, weight: 0, pull, point };
      for (const joint of joints) this.#pairs.set(joint, pair);
    }
  }

  /** How each joint pulled in the last step: three numbers. */
  get pulls(): Float64Array {
    return this.#pulls;
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
    const pair = this.#pairs.get(joint);
    if (pair) this.#stiffenPair(pair, joint, point, dt);
    else this.#stiffenBoth(joint, point, this.#pulls, joint * 3, dt, false);
  }

  /**
   * Joints of the same two bodies pull as one, in the middle, and by that part of the arm alone which lies along the pull:
   * what a wide plank's pull in one corner would turn, that in the other turns back. By themselves both would have the arm of
   * the corner, as if the plank could hardly swing (a bridge of forty between two posts tore within a second).
   */
  #stiffenPair(pair: Pair, joint: number, place: Float64Array, dt: number): void {
    const { a, b } = this.#system.edges[joint]!;
    const { pull, point } = pair;
    const p = joint * 3;
    const sign = a > b ? 1 : -1;
    const weight = hypot(this.#pulls[p]!, this.#pulls[p + 1]!, this.#pulls[p + 2]!);
    for (let x = 0; x < 3; x++) {
      pull[x]! += sign * this.#pulls[p + x]!;
      point[x]! += weight * place[x]!;
    }
    pair.weight += weight;
    if (++pair.seen < pair.joints) return;
    if (pair.weight > 0) {
      for (let x = 0; x < 3; x++) {
        pull[x]! *= sign;
        point[x]! /= pair.weight;
      }
      this.#stiffenBoth(joint, point, pull, 0, dt, true);
    }
    pair.seen = pair.weight = 0;
    pull.fill(0);
    point.fill(0);
  }

  #stiffenBoth(
    joint: number,
    point: Float64Array,
    pulls: Float64Array,
    at: number,
    dt: number,
    along: boolean,
  ): void {
    const { a, b } = this.#system.edges[joint]!;
    this.#stiffenAt(a, point, pulls, at, 1, dt, along);
    this.#stiffenAt(b, point, pulls, at, -1, dt, along);
  }

  #stiffenAt(
    body: number,
    point: Float64Array,
    pulls: Float64Array,
    at: number,
    sign: 1 | -1,
    dt: number,
    along: boolean,
  ): void {
    if (body < 0) return;
    const { place } = this.#bodies;
    const arm = this.#arm;
    for (let x = 0; x < 3; x++) arm[x] = point[x]! - place[body * 3 + x]!;
    if (along) {
      const share = dot3(arm, 0, pulls, at) / dot3(pulls, at, pulls, at);
      for (let x = 0; x < 3; x++) arm[x] = share * pulls[at + x]!;
    }
    this.#stiffen(body, arm, 0, pulls, at, sign, dt);
  }

  stiffenPin(pin: number, dt: number): void {
    const { pins, forest } = this.#system;
    const child = forest.childOf[pin]!;
    const parent = forest.parentOf[child]!;
    const sign = this.#signOf(pin, child);
    this.#stiffen(child, pins.factors.arms, pin * SIDE, this.#pulls, pin * 3, sign, dt);
    if (parent >= 0)
      this.#stiffen(
        parent,
        pins.factors.arms,
        pin * SIDE + 3,
        this.#pulls,
        pin * 3,
        sign === 1 ? -1 : 1,
        dt,
      );
  }

  /** At the end of an arm of the body, which is the joint's first one (`sign` 1) or its second. */
  #stiffen(
    body: number,
    arms: Float64Array,
    at: number,
    pulls: Float64Array,
    p: number,
    sign: 1 | -1,
    dt: number,
  ): void {
    const x = arms[at]!;
    const y = arms[at + 1]!;
    const z = arms[at + 2]!;
    const outward = sign * (pulls[p]! * x + pulls[p + 1]! * y + pulls[p + 2]! * z);
    // A push needs no care: it lets go by itself.
    if (!(outward > 0)) return;
    const length2 = x * x + y * y + z * z;
    const stiffness = outward * dt;
    const fast = stiffness / (this.#bodies.mass(body) * length2 + this.#bodies.leastMoment(body));
    const square = (fast / TOO_FAST) ** 2;
    const lost = 1 - 1 / (1 + square * square);
    const k = (stiffness * lost) / length2;
    // k (r² 1 - r rᵀ) on the turning of the body.
    const { inertia } = this.#system;
    const to = body * INERTIA + 1;
    inertia[to]! += k * (length2 - x * x);
    inertia[to + 1]! -= k * x * y;
    inertia[to + 2]! += k * (length2 - y * y);
    inertia[to + 3]! -= k * x * z;
    inertia[to + 4]! -= k * y * z;
    inertia[to + 5]! += k * (length2 - z * z);
  }
}
