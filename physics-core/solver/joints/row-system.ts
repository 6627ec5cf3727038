import { add6, BODY_BLOCK, copy6, dot6, INERTIA, ROW_BLOCK, ROWS, SIDE } from './blocks.js';
import { LoopRows } from './loop-rows.js';
import type { Component, Edge, Forest } from './forest.js';
import { PointSolver } from './point-solver.js';
import { TreeSolver } from './tree-solver.js';
import { SEARCH_ROUNDS } from '../tolerances.js';

/** How a row stands: it holds, or its impulse lies at its lower or upper bound. */
const HOLDS = 0;
const AT_LEAST = 1;
const AT_MOST = 2;

/**
 * All joints of a world as rows J v + carriedRate + γ λ = targetVelocity whose impulses λ lie between two bounds, solved directly: of all
 * velocities at which the rows hold it finds those nearest, in kinetic energy, to the ones predicted. Which bounded
 * rows (stops, motors) hold is searched for in a few rounds that start from how they stood last.
 */
export class RowSystem {
  edges: readonly Edge[] = [];
  forest!: Forest;
  /** Per body: inertia (mass, and what resists turning), momentum before, velocity after. */
  inertia = new Float64Array(0);
  momentum = new Float64Array(0);
  velocity = new Float64Array(0);
  /** What else resists the velocity of a body, linear and angular: a symmetric block, its lower half row by row. */
  readonly resisting = new Map<number, Float64Array>();
  /** Per joint: two blocks of rows, as body a and as body b sees them. */
  jacobian = new Float64Array(0);
  rowCount = new Int32Array(0);
  /** Per row. `threshold`: velocity past which a bounded row that gives way begins to hold. */
  targetVelocity = new Float64Array(0);
  threshold = new Float64Array(0);
  /** What ends of joints that carried bodies take along add to the rate. */
  carriedRate = new Float64Array(0);
  compliance = new Float64Array(0);
  least = new Float64Array(0);
  most = new Float64Array(0);
  impulse = new Float64Array(0);
  /** In loops: how far each row gives way besides, as a share of what it would do to its bodies by themselves. */
  give = 0;
  /** In loops: rows that close them are to give way as little as can be. */
  firm = false;
  #state = new Uint8Array(0);
  /** Rows of each joint that hold. */
  held = new Int32Array(0);
  heldCount = new Int32Array(0);

  /** The joints that are no rows: whether a joint is one of them. */
  readonly pins = new PointSolver();
  isPin = new Uint8Array(0);

  readonly #trees = new TreeSolver(this, this.pins);
  readonly #loops = new LoopRows(this);
  #load = new Float64Array(0);
  #changed = false;

  resize(bodies: number, edges: readonly Edge[], forest: Forest): void {
    this.edges = edges;
    this.forest = forest;
    if (this.#load.length < bodies * SIDE) this.#growBodies(2 * bodies);
    if (this.heldCount.length < edges.length) this.#growJoints(2 * edges.length);
    this.#state.fill(HOLDS);
    this.#loops.forget();
    this.isPin.fill(0);
    for (const { pins } of forest.components)
      for (const pin of pins) {
        this.isPin[pin] = 1;
        this.rowCount[pin] = this.heldCount[pin] = 0;
      }
  }

  #growBodies(room: number): void {
    this.inertia = new Float64Array(room * INERTIA);
    this.momentum = new Float64Array(room * SIDE);
    this.velocity = new Float64Array(room * SIDE);
    this.#load = new Float64Array(room * SIDE);
    this.#trees.growBodies(room);
    this.#loops.growBodies(room);
  }

  #growJoints(room: number): void {
    this.jacobian = new Float64Array(room * 2 * ROW_BLOCK);
    this.rowCount = new Int32Array(room);
    this.targetVelocity = new Float64Array(room * ROWS);
    this.threshold = new Float64Array(room * ROWS);
    this.carriedRate = new Float64Array(room * ROWS);
    this.compliance = new Float64Array(room * ROWS);
    this.least = new Float64Array(room * ROWS);
    this.most = new Float64Array(room * ROWS);
    this.impulse = new Float64Array(room * ROWS);
    this.#state = new Uint8Array(room * ROWS);
    this.held = new Int32Array(room * ROWS);
    this.heldCount = new Int32Array(room);
    this.isPin = new Uint8Array(room);
    this.pins.grow(room);
    this.#trees.growJoints(room);
    this.#loops.growJoints(room);
  }

  /** Before rows are filled: this row holds whatever impulse it takes. */
  unbounded(row: number): void {
    this.least[row] = -Infinity;
    this.most[row] = Infinity;
    this.#state[row] = HOLDS;
  }

  /** Nothing is known of how this row stood last. */
  forget(row: number): void {
    this.least[row] = NaN;
  }

  /** How its rows stood last: three numbers of each. */
  keep(joint: number): number[] {
    const kept: number[] = [];
    for (let i = joint * ROWS; i < (joint + 1) * ROWS; i++)
      kept.push(this.least[i]!, this.most[i]!, this.#state[i]!);
    return kept;
  }

  goOn(joint: number, kept: ArrayLike<number>, at: number): void {
    for (let i = joint * ROWS; i < (joint + 1) * ROWS; i++) {
      this.least[i] = kept[at++]!;
      this.most[i] = kept[at++]!;
      this.#state[i] = kept[at++]!;
    }
  }

  /** A row whose impulse is bounded. One that began to be bounded just now gives way at first. */
  bounded(row: number, least: number, most: number): void {
    const before = this.least[row] === least && this.most[row] === most;
    this.least[row] = least;
    this.most[row] = most;
    if (!before) this.#state[row] = least === 0 ? AT_LEAST : most === 0 ? AT_MOST : HOLDS;
  }

  /** False: singular; the velocities then mean nothing. */
  solve(component: Component): boolean {
    for (let round = 0; round < SEARCH_ROUNDS; round++) {
      for (const joint of component.rows) this.#hold(joint);
      const solver = component.loops.length > 0 ? this.#loops : this.#trees;
      if (!solver.factor(component)) return false;
      if (!this.again(component)) return false;
      this.#changed = false;
      for (const joint of component.rows) this.#search(joint);
      if (!this.#changed) return true;
    }
    return true;
  }

  /** By those rows that held when it was solved last, whatever they give now. False: singular. */
  solveAsHeld(component: Component): boolean {
    for (const joint of component.rows) this.#hold(joint);
    const solver = component.loops.length > 0 ? this.#loops : this.#trees;
    return solver.factor(component) && this.again(component);
  }

  /** With other wanted velocities or momentum; the same rows hold and the factors stand. */
  again(component: Component): boolean {
    for (const body of component.bodies) copy6(this.#load, body * SIDE, this.momentum, body * SIDE);
    for (const joint of component.rows) this.#pushBounded(joint);
    if (component.loops.length > 0) return this.#loops.solve(component, this.#load);
    this.#trees.solve(component, this.#load);
    return true;
  }

  #hold(joint: number): void {
    const at = joint * ROWS;
    let count = 0;
    for (let r = 0; r < this.rowCount[joint]!; r++)
      if (this.#state[at + r] === HOLDS) this.held[at + count++] = r;
    this.heldCount[joint] = count;
  }

  /** Rows at a bound push with it, whatever their velocity. */
  #pushBounded(joint: number): void {
    const at = joint * ROWS;
    for (let r = 0; r < this.rowCount[joint]!; r++) {
      const state = this.#state[at + r];
      if (state === HOLDS) continue;
      const impulse = state === AT_LEAST ? this.least[at + r]! : this.most[at + r]!;
      this.impulse[at + r] = impulse;
      if (impulse !== 0) this.push(joint, r, impulse, this.#load);
    }
  }

  #search(joint: number): void {
    for (let r = 0; r < this.rowCount[joint]!; r++) {
      const i = joint * ROWS + r;
      const least = this.least[i]!;
      const most = this.most[i]!;
      if (least === -Infinity && most === Infinity) continue;
      const before = this.#state[i]!;
      let state = before;
      if (before === HOLDS) {
        if (this.impulse[i]! < least) state = AT_LEAST;
        else if (this.impulse[i]! > most) state = AT_MOST;
      } else {
        const short =
          this.threshold[i]! - this.compliance[i]! * this.impulse[i]! - this.rate(joint, r);
        if (before === AT_LEAST ? short > 0 : short < 0) state = HOLDS;
      }
      if (state === before) continue;
      this.#state[i] = state;
      this.#changed = true;
    }
  }

  /** Whether a bounded row holds. */
  holds(row: number): boolean {
    return this.#state[row] === HOLDS;
  }

  /** The block of a body by itself, for a factor: what resists its velocity. */
  writeInertia(body: number, m: Float64Array, b: number): void {
    const { inertia } = this;
    const from = body * INERTIA;
    m[b] = m[b + 2] = m[b + 5] = inertia[from]!;
    m[b + 1] = m[b + 3] = m[b + 4] = 0;
    m[b + 6] = m[b + 7] = m[b + 8] = 0;
    m[b + 10] = m[b + 11] = m[b + 12] = 0;
    m[b + 15] = m[b + 16] = m[b + 17] = 0;
    m[b + 9] = inertia[from + 1]!;
    m[b + 13] = inertia[from + 2]!;
    m[b + 14] = inertia[from + 3]!;
    m[b + 18] = inertia[from + 4]!;
    m[b + 19] = inertia[from + 5]!;
    m[b + 20] = inertia[from + 6]!;
    const resisting = this.resisting.get(body);
    if (resisting) for (let i = 0; i < BODY_BLOCK; i++) m[b + i]! += resisting[i]!;
  }

  /** Adds the impulse of a row to the momenta of its bodies. */
  push(joint: number, row: number, impulse: number, momentum: Float64Array): void {
    const { a, b } = this.edges[joint]!;
    const at = joint * 2 * ROW_BLOCK + row * SIDE;
    if (a >= 0) add6(momentum, a * SIDE, this.jacobian, at, impulse);
    if (b >= 0) add6(momentum, b * SIDE, this.jacobian, at + ROW_BLOCK, impulse);
  }

  /** The rate of a row by the velocities found. */
  rate(joint: number, row: number): number {
    return this.rateBy(this.velocity, joint, row);
  }

  rateBy(velocity: Float64Array, joint: number, row: number): number {
    return this.product(velocity, joint, row) + this.carriedRate[joint * ROWS + row]!;
  }

  /** J v of a row. */
  product(velocity: Float64Array, joint: number, row: number): number {
    const { a, b } = this.edges[joint]!;
    const at = joint * 2 * ROW_BLOCK + row * SIDE;
    return (
      (a >= 0 ? dot6(this.jacobian, at, velocity, a * SIDE) : 0) +
      (b >= 0 ? dot6(this.jacobian, at + ROW_BLOCK, velocity, b * SIDE) : 0)
    );
  }
}
