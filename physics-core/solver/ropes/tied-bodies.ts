import { grown } from '../../base/grown.js';
import { SIDE } from '../joints/blocks.js';

const BLOCK = SIDE * SIDE;

/**
 * Bodies, one number after the other, that joints hold together with more: how they go in a step if no rope pulls, and what
 * an impulse on each of them does to them all. So ropes pull at all that hangs there, and what is held fast stays where it is.
 */
export class JoinedBodies {
  readonly first: number;
  readonly count: number;
  /** Numbers of their velocities, the first of them, and the one behind the last. */
  readonly width: number;
  readonly from: number;
  readonly to: number;
  /** Whether joints hold them in this step; FALSE: each counts by itself. */
  active = false;
  readonly free: Float64Array;
  /** Velocity for an impulse, 1/kg: a full matrix. It may be singular. */
  readonly compliance: Float64Array;
  /** Of `free`, of all that hangs together: twice the energy. */
  energy = 0;
  /** For who asks joints: whether no edit had torn them, and the numbers of the bodies there. */
  whole = true;
  readonly numbers: number[] = [];
  /** What ropes give them, as found. */
  readonly impulse: Float64Array;
  /** In a round: the same before it, and what the ropes resist each of them by, by rows of all bodies. */
  readonly given: Float64Array;
  resisting = new Float64Array(0);

  constructor(first: number, count: number) {
    this.first = first;
    this.count = count;
    this.width = SIDE * count;
    this.from = SIDE * first;
    this.to = this.from + this.width;
    this.free = new Float64Array(this.width);
    this.compliance = new Float64Array(this.width * this.width);
    this.impulse = new Float64Array(this.width);
    this.given = new Float64Array(this.width);
  }

  /** Whether one of them has this number. */
  has(body: number): boolean {
    return this.active && body >= this.first && body < this.first + this.count;
  }

  /** Number `r` of the velocities that impulses give them, from `at` on. */
  yield(r: number, impulse: Float64Array, at: number): number {
    let v = 0;
    for (let c = 0; c < this.width; c++)
      v += this.compliance[r * this.width + c]! * impulse[at + c]!;
    return v;
  }
}

/** The bodies that ropes are tied to, in a step: six numbers each, linear, then angular. */
export class TiedBodies {
  count = 0;
  /** What resists a change of their velocities: full blocks. */
  inertias = new Float64Array(0);
  /** What they have if no rope pulls, N s and N m s. */
  momenta = new Float64Array(0);
  /** As found. */
  velocities = new Float64Array(0);
  joined: readonly JoinedBodies[] = [];

  /** Those that joints hold together with it in this step; undefined: it counts by itself. */
  with(body: number): JoinedBodies | undefined {
    for (const each of this.joined) if (each.has(body)) return each;
    return undefined;
  }

  resize(count: number, joined: readonly JoinedBodies[] = []): void {
    this.count = count;
    this.joined = joined;
    if (this.momenta.length >= SIDE * count) return;
    this.inertias = grown(this.inertias, 2 * BLOCK * count);
    this.momenta = grown(this.momenta, 2 * SIDE * count);
    this.velocities = grown(this.velocities, 2 * SIDE * count);
  }
}
