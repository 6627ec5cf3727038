import { SIDE } from '../joints/blocks.js';
import { DenseLu } from '../matrix/dense-lu.js';

const BLOCK = SIDE * SIDE;

/**
 * Bodies, one number after the other, that joints hold together with more: how they go in a step if no rope pulls, and what an
 * impulse on each does to all of them. So ropes pull at all that hangs there, and what is held fast stays where it is: that
 * matrix may be singular, and is never inverted.
 */
export class JoinedBodies {
  readonly first: number;
  readonly count: number;
  /** Numbers of their velocities: how many, the first of them, and the one behind the last. */
  readonly width: number;
  readonly from: number;
  readonly to: number;
  /** Whether joints hold them in this step; FALSE: each counts by itself. */
  active = false;
  readonly free: Float64Array;
  /** Velocity for an impulse, 1/kg: a full symmetric matrix. */
  readonly compliance: Float64Array;
  /** Of `free`, of all that hangs together: twice the energy. */
  energy = 0;
  /** For who asks joints: whether no edit had torn them, and the numbers that the bodies have there. */
  whole = true;
  readonly numbers: number[] = [];
  /** What ropes give them, as found. */
  readonly impulse: Float64Array;
  /** In a round: the same before it, and what ropes resist these by, by the velocities of all bodies. */
  readonly #given: Float64Array;
  #resisting = new Float64Array(0);
  readonly #block = new DenseLu();
  #column = new Float64Array(0);
  readonly #taken: Float64Array;
  readonly #inverse: Float64Array;

  constructor(first: number, count: number) {
    const width = SIDE * count;
    this.first = first;
    this.count = count;
    this.width = width;
    this.from = SIDE * first;
    this.to = this.from + width;
    this.free = new Float64Array(width);
    this.impulse = new Float64Array(width);
    this.#given = new Float64Array(width);
    this.compliance = new Float64Array(width * width);
    this.#taken = new Float64Array(width * width);
    this.#inverse = new Float64Array(width * width);
  }

  /** Of so many bodies in all. */
  resize(bodies: number): void {
    this.#resisting = new Float64Array(this.width * SIDE * bodies);
    this.#column = new Float64Array(SIDE * bodies);
  }

  /** Whether one of them has this number. */
  has(body: number): boolean {
    return this.active && body >= this.first && body < this.first + this.count;
  }

  /** Number `r` of the velocities that impulses give them. */
  yield(r: number, impulse: Float64Array): number {
    const { compliance, width } = this;
    let v = 0;
    for (let c = 0; c < width; c++) v += compliance[r * width + c]! * impulse[c]!;
    return v;
  }

  // ---- a round of the search ------------------------------------------------------------------------------------------

  /**
   * Their rows have so far what ropes resist them by, and `rest` what those give them. They go as if free, and by what their joints
   * let that do.
   */
  assemble({ matrix, size }: DenseLu, rest: Float64Array, velocities: Float64Array): void {
    const { from, width, compliance, free } = this;
    const resisting = this.#resisting;
    for (let n = 0; n < width * size; n++) resisting[n] = matrix[from * size + n]!;
    for (let r = 0; r < width; r++) this.#given[r] = rest[from + r]!;
    for (let r = 0; r < width; r++) {
      const row = (from + r) * size;
      rest[from + r] = free[r]! - velocities[from + r]! + this.yield(r, this.#given);
      for (let c = 0; c < size; c++) {
        let sum = c === from + r ? 1 : 0;
        for (let k = 0; k < width; k++)
          sum += compliance[r * width + k]! * resisting[k * size + c]!;
        matrix[row + c] = sum;
      }
    }
  }

  /** What ropes give them, once all bodies go on by such a share of a change. */
  follow(change: Float64Array, share: number): void {
    const size = this.#column.length;
    for (let r = 0; r < this.width; r++) {
      let sum = this.#given[r]!;
      for (let c = 0; c < size; c++) sum -= share * this.#resisting[r * size + c]! * change[c]!;
      this.impulse[r] = sum;
    }
  }

  /** What ropes, and the bodies that they tie to them, resist each of them by: its own block, where all blocks stand. */
  tellResistance(system: DenseLu, out: Float64Array): void {
    const { from, width } = this;
    const block = this.#block;
    block.resize(width);
    for (let c = 0; c < width; c++) {
      this.#ask(system, c);
      for (let r = 0; r < width; r++) block.matrix[r * width + c] = this.#column[from + r]!;
    }
    block.factor();
    block.inverseBlock(0, width, this.#inverse);
    for (let r = 0; r < width; r++)
      for (let c = 0; c < SIDE; c++)
        out[BLOCK * this.first + SIDE * r + c] = this.#product(r, SIDE * Math.floor(r / SIDE) + c);
  }

  /** How all go when one velocity of these is given, and what ropes take from these then. */
  #ask(system: DenseLu, c: number): void {
    const { width } = this;
    const column = this.#column;
    const size = column.length;
    column.fill(0);
    column[this.from + c] = 1;
    system.solve(column);
    for (let r = 0; r < width; r++) {
      let sum = 0;
      for (let k = 0; k < size; k++) sum += this.#resisting[r * size + k]! * column[k]!;
      this.#taken[r * width + c] = sum;
    }
  }

  #product(r: number, c: number): number {
    const { width } = this;
    let sum = 0;
    for (let k = 0; k < width; k++)
      sum += this.#taken[r * width + k]! * this.#inverse[k * width + c]!;
    return sum;
  }

  // ---- one link at a time ---------------------------------------------------------------------------------------------

  /** As if free. */
  begin(velocities: Float64Array): void {
    velocities.set(this.free, this.from);
    this.impulse.fill(0);
  }

  /** The block of one of them by itself. */
  complianceOf(body: number, out: Float64Array, at: number): void {
    const first = SIDE * (body - this.first);
    for (let r = 0; r < SIDE; r++)
      for (let c = 0; c < SIDE; c++)
        out[at + SIDE * r + c] = this.compliance[(first + r) * this.width + first + c]!;
  }

  /** One of them is given an impulse: all go along. */
  push(body: number, given: Float64Array, velocities: Float64Array): void {
    const { from, width, compliance, impulse } = this;
    const at = SIDE * (body - this.first);
    for (let c = 0; c < SIDE; c++) {
      impulse[at + c]! += given[c]!;
      for (let r = 0; r < width; r++)
        velocities[from + r]! += compliance[r * width + at + c]! * given[c]!;
    }
  }
}
