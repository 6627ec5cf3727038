import { grownInt } from '../../base/grown.js';

// L Lᵀ of a symmetric positive definite matrix of 6 × 6 blocks, one row of blocks for each body, most of them empty.

/** Rows of a block. */
export const SIZE = 6;
export const BLOCK = 36;

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

// ---- blocks -----------------------------------------------------------------------------------------------------------
// All that a solve costs is here. Numbers that are used more than once stand in names of their own, which engines keep in
// registers, and what is short is written out: half of the time and less, with the same sums in the same order.

function copy(from: Float64Array, at: number, to: Float64Array, into: number, count: number): void {
  for (let i = 0; i < count; i++) to[into + i] = from[at + i]!;
}

/** Lower factor in place; its diagonal holds the inverse. */
function factorBlock(a: Float64Array, at: number): boolean {
  const m0 = a[at]!;
  if (!(m0 > 0)) return false;
  const d0 = 1 / Math.sqrt(m0);
  const l10 = a[at + 6]! * d0;
  const l20 = a[at + 12]! * d0;
  const l30 = a[at + 18]! * d0;
  const l40 = a[at + 24]! * d0;
  const l50 = a[at + 30]! * d0;
  const m1 = a[at + 7]! - l10 * l10;
  if (!(m1 > 0)) return false;
  const d1 = 1 / Math.sqrt(m1);
  const l21 = (a[at + 13]! - l20 * l10) * d1;
  const l31 = (a[at + 19]! - l30 * l10) * d1;
  const l41 = (a[at + 25]! - l40 * l10) * d1;
  const l51 = (a[at + 31]! - l50 * l10) * d1;
  const m2 = a[at + 14]! - l20 * l20 - l21 * l21;
  if (!(m2 > 0)) return false;
  const d2 = 1 / Math.sqrt(m2);
  const l32 = (a[at + 20]! - l30 * l20 - l31 * l21) * d2;
  const l42 = (a[at + 26]! - l40 * l20 - l41 * l21) * d2;
  const l52 = (a[at + 32]! - l50 * l20 - l51 * l21) * d2;
  const m3 = a[at + 21]! - l30 * l30 - l31 * l31 - l32 * l32;
  if (!(m3 > 0)) return false;
  const d3 = 1 / Math.sqrt(m3);
  const l43 = (a[at + 27]! - l40 * l30 - l41 * l31 - l42 * l32) * d3;
  const l53 = (a[at + 33]! - l50 * l30 - l51 * l31 - l52 * l32) * d3;
  const m4 = a[at + 28]! - l40 * l40 - l41 * l41 - l42 * l42 - l43 * l43;
  if (!(m4 > 0)) return false;
  const d4 = 1 / Math.sqrt(m4);
  const l54 = (a[at + 34]! - l50 * l40 - l51 * l41 - l52 * l42 - l53 * l43) * d4;
  const m5 = a[at + 35]! - l50 * l50 - l51 * l51 - l52 * l52 - l53 * l53 - l54 * l54;
  if (!(m5 > 0)) return false;
  a[at] = d0;
  a[at + 6] = l10;
  a[at + 7] = d1;
  a[at + 12] = l20;
  a[at + 13] = l21;
  a[at + 14] = d2;
  a[at + 18] = l30;
  a[at + 19] = l31;
  a[at + 20] = l32;
  a[at + 21] = d3;
  a[at + 24] = l40;
  a[at + 25] = l41;
  a[at + 26] = l42;
  a[at + 27] = l43;
  a[at + 28] = d4;
  a[at + 30] = l50;
  a[at + 31] = l51;
  a[at + 32] = l52;
  a[at + 33] = l53;
  a[at + 34] = l54;
  a[at + 35] = 1 / Math.sqrt(m5);
  return true;
}

/** A ← A L⁻ᵀ, for all rows between two places. */
function divideRows(a: Float64Array, from: number, to: number, l: number): void {
  const l00 = a[l]!;
  const l10 = a[l + 6]!;
  const l11 = a[l + 7]!;
  const l20 = a[l + 12]!;
  const l21 = a[l + 13]!;
  const l22 = a[l + 14]!;
  const l30 = a[l + 18]!;
  const l31 = a[l + 19]!;
  const l32 = a[l + 20]!;
  const l33 = a[l + 21]!;
  const l40 = a[l + 24]!;
  const l41 = a[l + 25]!;
  const l42 = a[l + 26]!;
  const l43 = a[l + 27]!;
  const l44 = a[l + 28]!;
  const l50 = a[l + 30]!;
  const l51 = a[l + 31]!;
  const l52 = a[l + 32]!;
  const l53 = a[l + 33]!;
  const l54 = a[l + 34]!;
  const l55 = a[l + 35]!;
  for (let row = from; row < to; row += SIZE) {
    const x0 = a[row]! * l00;
    const x1 = (a[row + 1]! - x0 * l10) * l11;
    const x2 = (a[row + 2]! - x0 * l20 - x1 * l21) * l22;
    const x3 = (a[row + 3]! - x0 * l30 - x1 * l31 - x2 * l32) * l33;
    const x4 = (a[row + 4]! - x0 * l40 - x1 * l41 - x2 * l42 - x3 * l43) * l44;
    const x5 = (a[row + 5]! - x0 * l50 - x1 * l51 - x2 * l52 - x3 * l53 - x4 * l54) * l55;
    a[row] = x0;
    a[row + 1] = x1;
    a[row + 2] = x2;
    a[row + 3] = x3;
    a[row + 4] = x4;
    a[row + 5] = x5;
  }
}

/** A ← A - B Cᵀ, two rows at a time. */
function takeProduct(v: Float64Array, a: number, b: number, c: number): void {
  for (let p = b, row = a; p < b + BLOCK; p += 2 * SIZE, row += 2 * SIZE) {
    const p0 = v[p]!;
    const p1 = v[p + 1]!;
    const p2 = v[p + 2]!;
    const p3 = v[p + 3]!;
    const p4 = v[p + 4]!;
    const p5 = v[p + 5]!;
    const q0 = v[p + 6]!;
    const q1 = v[p + 7]!;
    const q2 = v[p + 8]!;
    const q3 = v[p + 9]!;
    const q4 = v[p + 10]!;
    const q5 = v[p + 11]!;
    for (let q = c, to = row; q < c + BLOCK; q += SIZE, to++) {
      const c0 = v[q]!;
      const c1 = v[q + 1]!;
      const c2 = v[q + 2]!;
      const c3 = v[q + 3]!;
      const c4 = v[q + 4]!;
      const c5 = v[q + 5]!;
      v[to]! -= p0 * c0 + p1 * c1 + p2 * c2 + p3 * c3 + p4 * c4 + p5 * c5;
      v[to + SIZE]! -= q0 * c0 + q1 * c1 + q2 * c2 + q3 * c3 + q4 * c4 + q5 * c5;
    }
  }
}

/** A ← A - B Bᵀ, its lower half. */
function takeSquare(v: Float64Array, a: number, b: number): void {
  for (let q = b, column = 0; q < b + BLOCK; q += SIZE, column++) {
    const q0 = v[q]!;
    const q1 = v[q + 1]!;
    const q2 = v[q + 2]!;
    const q3 = v[q + 3]!;
    const q4 = v[q + 4]!;
    const q5 = v[q + 5]!;
    for (let p = q, to = a + column * (SIZE + 1); p < b + BLOCK; p += SIZE, to += SIZE)
      v[to]! -=
        v[p]! * q0 +
        v[p + 1]! * q1 +
        v[p + 2]! * q2 +
        v[p + 3]! * q3 +
        v[p + 4]! * q4 +
        v[p + 5]! * q5;
  }
}

function forwardBlock(l: Float64Array, at: number, x: Float64Array, from: number): void {
  const x0 = x[from]! * l[at]!;
  const x1 = (x[from + 1]! - l[at + 6]! * x0) * l[at + 7]!;
  const x2 = (x[from + 2]! - l[at + 12]! * x0 - l[at + 13]! * x1) * l[at + 14]!;
  const x3 = (x[from + 3]! - l[at + 18]! * x0 - l[at + 19]! * x1 - l[at + 20]! * x2) * l[at + 21]!;
  const x4 =
    (x[from + 4]! - l[at + 24]! * x0 - l[at + 25]! * x1 - l[at + 26]! * x2 - l[at + 27]! * x3) *
    l[at + 28]!;
  x[from + 5] =
    (x[from + 5]! -
      l[at + 30]! * x0 -
      l[at + 31]! * x1 -
      l[at + 32]! * x2 -
      l[at + 33]! * x3 -
      l[at + 34]! * x4) *
    l[at + 35]!;
  x[from] = x0;
  x[from + 1] = x1;
  x[from + 2] = x2;
  x[from + 3] = x3;
  x[from + 4] = x4;
}

function backwardBlock(l: Float64Array, at: number, x: Float64Array, from: number): void {
  const x5 = x[from + 5]! * l[at + 35]!;
  const x4 = (x[from + 4]! - l[at + 34]! * x5) * l[at + 28]!;
  const x3 = (x[from + 3]! - l[at + 33]! * x5 - l[at + 27]! * x4) * l[at + 21]!;
  const x2 = (x[from + 2]! - l[at + 32]! * x5 - l[at + 26]! * x4 - l[at + 20]! * x3) * l[at + 14]!;
  const x1 =
    (x[from + 1]! - l[at + 31]! * x5 - l[at + 25]! * x4 - l[at + 19]! * x3 - l[at + 13]! * x2) *
    l[at + 7]!;
  x[from] =
    (x[from]! -
      l[at + 30]! * x5 -
      l[at + 24]! * x4 -
      l[at + 18]! * x3 -
      l[at + 12]! * x2 -
      l[at + 6]! * x1) *
    l[at]!;
  x[from + 1] = x1;
  x[from + 2] = x2;
  x[from + 3] = x3;
  x[from + 4] = x4;
  x[from + 5] = x5;
}

/** x of each row of a column ← x - A x[from], for the blocks A from `at` on. */
function takeTimes(
  a: Float64Array,
  at: number,
  x: Float64Array,
  from: number,
  rows: Int32Array,
  first: number,
  end: number,
): void {
  const x0 = x[from]!;
  const x1 = x[from + 1]!;
  const x2 = x[from + 2]!;
  const x3 = x[from + 3]!;
  const x4 = x[from + 4]!;
  const x5 = x[from + 5]!;
  for (let p = first, row = at; p < end; p++) {
    const to = rows[p]! * SIZE;
    for (let i = to; i < to + SIZE; i++, row += SIZE)
      x[i]! -=
        0 +
        a[row]! * x0 +
        a[row + 1]! * x1 +
        a[row + 2]! * x2 +
        a[row + 3]! * x3 +
        a[row + 4]! * x4 +
        a[row + 5]! * x5;
  }
}

/** x[to] ← x[to] - Aᵀ x of each row of a column, for the blocks A from `at` on. */
function takeTransposedTimes(
  a: Float64Array,
  at: number,
  x: Float64Array,
  to: number,
  rows: Int32Array,
  first: number,
  end: number,
): void {
  let x0 = x[to]!;
  let x1 = x[to + 1]!;
  let x2 = x[to + 2]!;
  let x3 = x[to + 3]!;
  let x4 = x[to + 4]!;
  let x5 = x[to + 5]!;
  for (let p = first, row = at; p < end; p++) {
    const from = rows[p]! * SIZE;
    for (let i = from; i < from + SIZE; i++, row += SIZE) {
      const value = x[i]!;
      x0 -= a[row]! * value;
      x1 -= a[row + 1]! * value;
      x2 -= a[row + 2]! * value;
      x3 -= a[row + 3]! * value;
      x4 -= a[row + 4]! * value;
      x5 -= a[row + 5]! * value;
    }
  }
  x[to] = x0;
  x[to + 1] = x1;
  x[to + 2] = x2;
  x[to + 3] = x3;
  x[to + 4] = x4;
  x[to + 5] = x5;
}
