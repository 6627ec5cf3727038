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
} from './blocks-of-six.js';

// L Lᵀ of a symmetric positive definite matrix of 6 × 6 blocks, one row of blocks for each body, most of them empty.

export { SIZE };

/**
 * A sparse block matrix and its factor. Blocks are full, row after row; those off the diagonal lie below it, and of those on
 * it only the lower half is looked at. Bodies whose blocks change from one factor to the next are eliminated last: what
 * comes before them is factored once.
 */
export class SparseCholesky {
  /** Rows of blocks. */
  count = 0;
  readonly #changing = new Set<number>();
  /** Rows that do not change come before this one, and so many products are theirs. */
  #firstChanging = 0;
  #constantProducts = 0;
  /** Number of the row in which a body is eliminated. */
  #place = new Int32Array(16);
  /** Where the column of a row begins in `#rows`; its blocks off the diagonal follow those on it in `values`. */
  #starts = new Int32Array(17);
  #rows = new Int32Array(16);
  /** Where the products of a column's blocks go, in the order in which they are taken. */
  #targets = new Int32Array(16);
  /** The diagonal blocks by row, then the others in the order of `#rows`; behind them those that change, as the rest leaves them. */
  values = new Float64Array(2 * BLOCK);
  readonly #neighbours: Set<number>[] = [];
  /** Who is connected (a count + b) and who changes (-1 - i), in the order in which it is told, and how many of that. */
  #told = new Int32Array(64);
  #toldCount = 0;
  /** The same of what was analysed last. */
  #known = new Int32Array(64);
  #knownCount = -1;
  #knownBodies = 0;
  #permuted = new Float64Array(SIZE);
  /** Products of two blocks that factoring takes: its cost. */
  products = 0;

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

  /**
   * Finds an order of elimination (that of the least degree) and what it fills in, unless that is known. False: it takes more
   * than `most` products.
   */
  analyse(most: number): boolean {
    if (this.#isKnown()) return true;
    this.#knownCount = -1;
    if (!this.#look(most)) return false;
    const before = this.#known;
    this.#known = this.#told;
    this.#told = before;
    this.#knownCount = this.#toldCount;
    this.#knownBodies = this.count;
    return true;
  }

  #hear(): void {
    const { count } = this;
    for (let i = 0; i < count; i++) (this.#neighbours[i] ??= new Set()).clear();
    this.#changing.clear();
    for (let i = 0; i < this.#toldCount; i++) {
      const what = this.#told[i]!;
      if (what < 0) this.#changing.add(-1 - what);
      else this.#join(Math.floor(what / count), what % count);
    }
  }

  #join(a: number, b: number): void {
    this.#neighbours[a]!.add(b);
    this.#neighbours[b]!.add(a);
  }

  #look(most: number): boolean {
    this.#hear();
    const { count } = this;
    if (this.#place.length < count) this.#place = new Int32Array(2 * count);
    if (this.#starts.length <= count) this.#starts = new Int32Array(2 * count + 1);
    const constant = new Set<number>();
    const changing = new Set<number>();
    for (let i = 0; i < count; i++) (this.#changing.has(i) ? changing : constant).add(i);
    this.#firstChanging = constant.size;
    const columns: number[][] = [];
    this.products = 0;
    for (const left of [constant, changing])
      while (left.size > 0) {
        const i = this.#leastDegree(left);
        left.delete(i);
        this.#place[i] = columns.length;
        const near = [...this.#neighbours[i]!];
        columns.push(near);
        this.products += 1 + near.length + (near.length * (near.length + 1)) / 2;
        if (this.products > most) return false;
        this.#eliminate(i, near);
      }
    this.#lay(columns);
    return true;
  }

  #leastDegree(left: Set<number>): number {
    let best = -1;
    let least = Infinity;
    for (const i of left) {
      const degree = this.#neighbours[i]!.size;
      if (degree >= least) continue;
      best = i;
      least = degree;
      if (degree <= 1) break;
    }
    return best;
  }

  #eliminate(i: number, near: readonly number[]): void {
    for (const a of near) this.#neighbours[a]!.delete(i);
    for (let p = 0; p < near.length; p++)
      for (let q = 0; q < p; q++) this.#join(near[p]!, near[q]!);
  }

  #lay(columns: readonly number[][]): void {
    const total = columns.reduce((sum, { length }) => sum + length, 0);
    if (this.#rows.length < total) this.#rows = new Int32Array(2 * total);
    const room = 2 * (this.count + total) * BLOCK;
    if (this.values.length < room) this.values = new Float64Array(2 * room);
    let at = 0;
    columns.forEach((near, k) => {
      this.#starts[k] = at;
      const rows = near.map((i) => this.#place[i]!).sort((a, b) => a - b);
      for (const row of rows) this.#rows[at++] = row;
    });
    this.#starts[this.count] = at;
    this.#aim();
  }

  #aim(): void {
    if (this.#targets.length < this.products) this.#targets = new Int32Array(2 * this.products);
    const rows = this.#rows;
    let next = 0;
    for (let k = 0; k < this.count; k++) {
      if (k === this.#firstChanging) this.#constantProducts = next;
      for (let p = this.#starts[k]!; p < this.#starts[k + 1]!; p++) {
        const i = rows[p]!;
        for (let q = this.#starts[k]!; q < p; q++) this.#targets[next++] = this.#find(i, rows[q]!);
        this.#targets[next++] = i * BLOCK;
      }
    }
  }

  // ---- values -------------------------------------------------------------------------------------------------------

  clear(): void {
    this.values.fill(0, 0, (this.count + this.#starts[this.count]!) * BLOCK);
  }

  /** Where the diagonal block of a body begins. */
  diagonal(i: number): number {
    return this.#place[i]! * BLOCK;
  }

  /** Where the block between two bodies begins; negative, less one: it is that of (b, a). */
  between(a: number, b: number): number {
    const p = this.#place[a]!;
    const q = this.#place[b]!;
    return p > q ? this.#find(p, q) : -1 - this.#find(q, p);
  }

  /** The block of row `i` in column `k`, i > k. */
  #find(i: number, k: number): number {
    let low = this.#starts[k]!;
    let high = this.#starts[k + 1]! - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#rows[middle]! < i) low = middle + 1;
      else high = middle;
    }
    return (this.count + low) * BLOCK;
  }

  // ---- factor and solution ------------------------------------------------------------------------------------------

  /** Eliminates what does not change, once all of that is added. False: not positive definite. */
  factorConstant(): boolean {
    if (!this.#factor(0, this.#firstChanging, 0)) return false;
    const { values, count } = this;
    const first = this.#firstChanging;
    const end = (count + this.#starts[count]!) * BLOCK;
    values.copyWithin(end + first * BLOCK, first * BLOCK, count * BLOCK);
    const others = (count + this.#starts[first]!) * BLOCK;
    values.copyWithin(end + others, others, end);
    return true;
  }

  /** Only what changes is to be added anew. */
  restore(): void {
    const { values, count } = this;
    const first = this.#firstChanging;
    const end = (count + this.#starts[count]!) * BLOCK;
    values.copyWithin(first * BLOCK, end + first * BLOCK, end + count * BLOCK);
    const others = (count + this.#starts[first]!) * BLOCK;
    values.copyWithin(others, end + others, 2 * end);
  }

  /** The rest, in place. False: not positive definite. */
  factor(): boolean {
    return this.#factor(this.#firstChanging, this.count, this.#constantProducts);
  }

  #factor(first: number, end: number, next: number): boolean {
    const { values, count } = this;
    const starts = this.#starts;
    const targets = this.#targets;
    for (let k = first; k < end; k++) {
      const diagonal = k * BLOCK;
      if (!factorBlock(values, diagonal)) return false;
      const from = (count + starts[k]!) * BLOCK;
      const to = (count + starts[k + 1]!) * BLOCK;
      divideRows(values, from, to, diagonal);
      for (let p = from; p < to; p += BLOCK) {
        for (let q = from; q < p; q += BLOCK) takeProduct(values, targets[next++]!, p, q);
        takeSquare(values, targets[next++]!, p);
      }
    }
    return true;
  }

  /** L Lᵀ x = b, in place; six numbers a body. */
  solve(x: Float64Array): void {
    const { values, count } = this;
    const starts = this.#starts;
    const rows = this.#rows;
    if (this.#permuted.length < SIZE * count) this.#permuted = new Float64Array(2 * SIZE * count);
    const y = this.#permuted;
    for (let i = 0; i < count; i++) copy(x, i * SIZE, y, this.#place[i]! * SIZE, SIZE);
    for (let k = 0; k < count; k++) {
      forwardBlock(values, k * BLOCK, y, k * SIZE);
      takeTimes(
        values,
        (count + starts[k]!) * BLOCK,
        y,
        k * SIZE,
        rows,
        starts[k]!,
        starts[k + 1]!,
      );
    }
    for (let k = count - 1; k >= 0; k--) {
      const at = (count + starts[k]!) * BLOCK;
      takeTransposedTimes(values, at, y, k * SIZE, rows, starts[k]!, starts[k + 1]!);
      backwardBlock(values, k * BLOCK, y, k * SIZE);
    }
    for (let i = 0; i < count; i++) copy(y, this.#place[i]! * SIZE, x, i * SIZE, SIZE);
  }
}

function copy(from: Float64Array, at: number, to: Float64Array, into: number, count: number): void {
  for (let i = 0; i < count; i++) to[into + i] = from[at + i]!;
}
