import { backward, factor, forward, rowOf } from '../../base/cholesky.js';
import { INERTIA, ROW_BLOCK, ROWS, SIDE } from './blocks.js';
import type { Component } from './forest.js';
import type { RowSystem } from './row-system.js';
import type { TreeSolver } from './tree-solver.js';

/** The dense system of a component's loops costs the cube of this many rows. */
const MOST_ROWS = 96;

/**
 * Added to each row's response, as a share of what the row would do to its bodies by themselves: loops that are closed
 * more than once would be singular. Where they are, the rounding of poses makes them all but rigid, and less than this
 * brakes them (measured: at 1e-9 a cardan shaft on two hinges loses 2 % of its energy in 4 s at 1/960 s).
 */
const COMPLIANCE = 1e-6;

/** The rows of joints that close loops: a small dense system on top of the trees. */
export class LoopRows {
  readonly #system: RowSystem;
  readonly #trees: TreeSolver;
  /** Whose rows these are, how many, and their factors. */
  #component: Component | undefined;
  #count = 0;
  #rows = new Int32Array(0);
  #matrix = new Float64Array(0);
  #impulse = new Float64Array(0);
  #load = new Float64Array(0);

  constructor(system: RowSystem, trees: TreeSolver) {
    this.#system = system;
    this.#trees = trees;
  }

  /** Once the trees are factored. False: singular, or too many. */
  factor(component: Component): boolean {
    this.#component = component;
    if (!this.#collect(component)) return false;
    if (this.#count === 0) return true;
    this.#fill(component);
    return factor(this.#matrix, 0, this.#count);
  }

  /** Velocities of trees and loops under `load`, which is used up. False: singular, or too many. */
  solve(component: Component, load: Float64Array): boolean {
    if (component !== this.#component && !this.factor(component)) return false;
    const n = this.#count;
    if (n > 0) {
      this.#copy(component, load, this.#load);
      this.#trees.solve(component, this.#load, 1);
      const { targetVelocity } = this.#system;
      for (let i = 0; i < n; i++)
        this.#impulse[i] = targetVelocity[this.#rows[i]!]! - this.#rate(i);
      forward(this.#matrix, 0, n, this.#impulse, 0);
      backward(this.#matrix, 0, n, this.#impulse, 0);
      for (let i = 0; i < n; i++) this.#push(i, this.#impulse[i]!, load);
    }
    this.#trees.solve(component, load, 1);
    return true;
  }

  /** How an impulse on each row moves all of them. */
  #fill(component: Component): void {
    const { compliance } = this.#system;
    const n = this.#count;
    let largest = 0;
    for (let j = 0; j < n; j++) {
      this.#copy(component, undefined, this.#load);
      this.#push(j, 1, this.#load);
      this.#trees.solve(component, this.#load, 0);
      for (let i = j; i < n; i++) this.#matrix[rowOf(i) + j] = this.#product(i);
      largest = Math.max(largest, this.#alone(j));
    }
    for (let i = 0; i < n; i++)
      this.#matrix[rowOf(i) + i]! += compliance[this.#rows[i]!]! + COMPLIANCE * largest;
  }

  /** What an impulse on a row would do to it if no joint held its bodies, by the diagonals of their inertia. */
  #alone(i: number): number {
    const { edges } = this.#system;
    const row = this.#rows[i]!;
    const joint = Math.floor(row / ROWS);
    const { a, b } = edges[joint]!;
    const at = joint * 2 * ROW_BLOCK + (row % ROWS) * SIDE;
    return this.#aloneOn(a, at) + this.#aloneOn(b, at + ROW_BLOCK);
  }

  #aloneOn(body: number, at: number): number {
    if (body < 0) return 0;
    const { inertia, jacobian } = this.#system;
    let sum = 0;
    const from = body * INERTIA;
    for (let x = 0; x < 3; x++) {
      sum += jacobian[at + x]! ** 2 / inertia[from]!;
      sum += jacobian[at + 3 + x]! ** 2 / inertia[from + 1 + rowOf(x) + x]!;
    }
    return sum;
  }

  #copy({ bodies }: Component, from: Float64Array | undefined, to: Float64Array): void {
    for (const body of bodies) {
      const p = body * SIDE;
      for (let x = p; x < p + SIDE; x++) to[x] = from ? from[x]! : 0;
    }
  }

  #product(i: number): number {
    const row = this.#rows[i]!;
    const { velocity } = this.#system;
    return this.#system.product(velocity, Math.floor(row / ROWS), row % ROWS);
  }

  #rate(i: number): number {
    const row = this.#rows[i]!;
    return this.#system.rate(Math.floor(row / ROWS), row % ROWS);
  }

  #push(i: number, impulse: number, load: Float64Array): void {
    const row = this.#rows[i]!;
    this.#system.impulse[row] = impulse;
    this.#system.push(Math.floor(row / ROWS), row % ROWS, impulse, load);
  }

  /** The rows that hold. False: too many. */
  #collect({ loops }: Component): boolean {
    const { held, heldCount, momentum } = this.#system;
    let count = 0;
    for (const joint of loops) count += heldCount[joint]!;
    if (count > MOST_ROWS) return false;
    if (this.#rows.length < count) this.#grow(2 * count);
    if (this.#load.length < momentum.length) this.#load = new Float64Array(momentum.length);
    this.#count = 0;
    for (const joint of loops) {
      for (let r = 0; r < heldCount[joint]!; r++)
        this.#rows[this.#count++] = joint * ROWS + held[joint * ROWS + r]!;
    }
    return true;
  }

  #grow(room: number): void {
    this.#rows = new Int32Array(room);
    this.#impulse = new Float64Array(room);
    this.#matrix = new Float64Array(rowOf(room));
  }
}
