import { grownInt } from '../../base/grown.js';
import {
  backwardBlock,
  BLOCK,
  divideRows,
  factorBlock,
  forwardBlock,
  SIZE,
  takeProduct,
  takeSquare,
  takeTimes,
  takeTransposedTimes,
} from './six-blocks.js';
import { SparsePattern } from './sparse-pattern.js';

// L Lᵀ of a symmetric positive definite matrix of 6 × 6 blocks, one row of blocks for each body, most of them empty.

/**
 * A sparse matrix of such blocks and its factor. Blocks are full, row after row; those off the diagonal lie below it, and of
 * those on it only the lower half is looked at. Bodies whose blocks change from one factor to the next are eliminated last:
 * what comes before them is factored once.
 */
export class BlockCholesky {
  /** Rows of blocks. */
  count = 0;
  readonly #pattern = new SparsePattern();
  /** Rows that do not change come before this one, and so many targets of products are theirs. */
  #firstChanging = 0;
  #constantTargets = 0;
  /** The diagonal blocks by row, then the others as the pattern has them; behind them those that change, as the rest leaves them. */
  values = new Float64Array(2 * BLOCK);
  readonly #neighbours: Set<number>[] = [];
  readonly #changing = new Set<number>();
  /** Who is connected (a count + b) and who changes (-1 - i), in the order in which it is told, and how many of that. */
  #told = new Int32Array(64);
  #toldCount = 0;
  /** The same of what was analysed last. */
  #known = new Int32Array(64);
  #knownCount = -1;
  #knownBodies = 0;
  #permuted = new Float64Array(SIZE);

  // ---- structure ----------------------------------------------------------------------------------------------------

  /** So many bodies, none of which touches another. */
  begin(count: number): void {
    this.count = count;
    this.#toldCount = 0;
  }

  /** Blocks of this body are others in each factor. */
  changes(i: number): void {
    this.#tell(-1 - i);
  }

  connect(a: number, b: number): void {
    this.#tell(a * this.count + b);
  }

  #tell(what: number): void {
    if (this.#told.length === this.#toldCount)
      this.#told = grownInt(this.#told, 2 * this.#toldCount);
    this.#told[this.#toldCount++] = what;
  }

  /** Whether nobody touches another than when this was analysed last: so it mostly is from step to step. */
  #isKnown(): boolean {
    if (this.#knownBodies !== this.count || this.#knownCount !== this.#toldCount) return false;
    for (let i = 0; i < this.#toldCount; i++) if (this.#told[i] !== this.#known[i]) return false;
    return true;
  }

  /** Finds an order of elimination and what it fills in, unless that is known. False: it takes more than `most` products. */
  analyse(most: number): boolean {
    if (this.#isKnown()) return true;
    this.#knownCount = -1;
    this.#hear();
    const constant = new Set<number>();
    const changing = new Set<number>();
    for (let i = 0; i < this.count; i++) (this.#changing.has(i) ? changing : constant).add(i);
    this.#firstChanging = constant.size;
    if (!this.#pattern.find(this.#neighbours, [constant, changing], most, false)) return false;
    if (this.products > most) return false;
    const room = 2 * this.#end;
    if (this.values.length < room) this.values = new Float64Array(2 * room);
    const before = this.#known;
    this.#known = this.#told;
    this.#told = before;
    this.#knownCount = this.#toldCount;
    this.#knownBodies = this.count;
    return true;
  }

  #hear(): void {
    const { count } = this;
    const neighbours = this.#neighbours;
    for (let i = 0; i < count; i++) (neighbours[i] ??= new Set()).clear();
    this.#changing.clear();
    for (let t = 0; t < this.#toldCount; t++) {
      const what = this.#told[t]!;
      if (what < 0) this.#changing.add(-1 - what);
      else {
        const a = Math.floor(what / count);
        const b = what % count;
        neighbours[a]!.add(b);
        neighbours[b]!.add(a);
      }
    }
  }

  /** Of blocks, what factoring takes: its cost. Those that a block is divided by, or factored itself, count as well. */
  get products(): number {
    return this.count + this.#pattern.blocks + this.#pattern.products;
  }

  // ---- values -------------------------------------------------------------------------------------------------------

  /** Where blocks end in `values`. */
  get #end(): number {
    return (this.count + this.#pattern.blocks) * BLOCK;
  }

  clear(): void {
    this.values.fill(0, 0, this.#end);
  }

  /** Where the diagonal block of a body begins. */
  diagonal(i: number): number {
    return this.#pattern.place[i]! * BLOCK;
  }

  /** Where the block between two bodies begins; negative, less one: it is that of (b, a). */
  between(a: number, b: number): number {
    const block = this.#pattern.between(a, b);
    return block < 0 ? -1 - (this.count - 1 - block) * BLOCK : (this.count + block) * BLOCK;
  }

  // ---- factor and solution ------------------------------------------------------------------------------------------

  /** Eliminates what does not change, once all of that is added. False: not positive definite. */
  factorConstant(): boolean {
    this.#constantTargets = this.#factor(0, this.#firstChanging, 0);
    if (this.#constantTargets < 0) return false;
    this.#copyChanging(0, this.#end);
    return true;
  }

  /** Only what changes is to be added anew. */
  restore(): void {
    this.#copyChanging(this.#end, 0);
  }

  /** The blocks that change, diagonal and others, of all those that begin at `from`. */
  #copyChanging(from: number, to: number): void {
    const { values, count } = this;
    const first = this.#firstChanging * BLOCK;
    const others = (count + this.#pattern.starts[this.#firstChanging]!) * BLOCK;
    values.copyWithin(to + first, from + first, from + count * BLOCK);
    values.copyWithin(to + others, from + others, from + this.#end);
  }

  /** The rest, in place. False: not positive definite. */
  factor(): boolean {
    return this.#factor(this.#firstChanging, this.count, this.#constantTargets) >= 0;
  }

  /** From the target `next` on; returns the one after all, or -1: not positive definite. */
  #factor(first: number, end: number, next: number): number {
    const { values, count } = this;
    const { starts, rows, targets } = this.#pattern;
    for (let k = first; k < end; k++) {
      const diagonal = k * BLOCK;
      if (!factorBlock(values, diagonal)) return -1;
      const from = (count + starts[k]!) * BLOCK;
      const to = (count + starts[k + 1]!) * BLOCK;
      divideRows(values, from, to, diagonal);
      for (let p = from, b = starts[k]!; p < to; p += BLOCK, b++) {
        takeSquare(values, rows[b]! * BLOCK, p);
        for (let q = p + BLOCK; q < to; q += BLOCK)
          takeProduct(values, (count + targets[next++]!) * BLOCK, q, p);
      }
    }
    return next;
  }

  /** L Lᵀ x = b, in place; six numbers a body. */
  solve(x: Float64Array): void {
    const { values, count } = this;
    const { place, starts, rows } = this.#pattern;
    if (this.#permuted.length < SIZE * count) this.#permuted = new Float64Array(2 * SIZE * count);
    const y = this.#permuted;
    for (let i = 0; i < count; i++)
      for (let k = 0; k < SIZE; k++) y[place[i]! * SIZE + k] = x[i * SIZE + k]!;
    for (let k = 0; k < count; k++) {
      const at = (count + starts[k]!) * BLOCK;
      forwardBlock(values, k * BLOCK, y, k * SIZE);
      takeTimes(values, at, y, k * SIZE, rows, starts[k]!, starts[k + 1]!);
    }
    for (let k = count - 1; k >= 0; k--) {
      const at = (count + starts[k]!) * BLOCK;
      takeTransposedTimes(values, at, y, k * SIZE, rows, starts[k]!, starts[k + 1]!);
      backwardBlock(values, k * BLOCK, y, k * SIZE);
    }
    for (let i = 0; i < count; i++)
      for (let k = 0; k < SIZE; k++) x[i * SIZE + k] = y[place[i]! * SIZE + k]!;
  }
}
