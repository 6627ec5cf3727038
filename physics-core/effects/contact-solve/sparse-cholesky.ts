// L Lᵀ of a symmetric positive definite matrix of 6 × 6 blocks, one row of blocks for each body, most of them empty.

/** Rows of a block. */
export const SIZE = 6;
export const BLOCK = SIZE * SIZE;

/**
 * A sparse block matrix and its factor. Blocks are full, row after row; those off the diagonal lie below it. Bodies whose
 * blocks change from one factor to the next are eliminated last: what comes before them is factored once.
 */
export class SparseCholesky {
  /** Rows of blocks. */
  count = 0;
  readonly #changing = new Set<number>();
  /** Rows that do not change come before this one, and so many products are theirs. */
  #firstChanging = 0;
  #constantProducts = 0;
  /** Blocks that change, as the others leave them: those on the diagonal, then the rest. */
  #left = new Float64Array(BLOCK);
  /** Number of the row in which a body is eliminated. */
  #place = new Int32Array(16);
  /** Where the column of a row begins in `#rows`; its blocks off the diagonal follow those on it in `values`. */
  #starts = new Int32Array(17);
  #rows = new Int32Array(16);
  /** Where the products of a column's blocks go, in the order in which they are taken. */
  #targets = new Int32Array(16);
  /** The diagonal blocks by row, then the others in the order of `#rows`. */
  values = new Float64Array(BLOCK);
  readonly #neighbours: Set<number>[] = [];
  #permuted = new Float64Array(SIZE);
  /** Products of two blocks that factoring takes: its cost. */
  products = 0;

  // ---- structure ----------------------------------------------------------------------------------------------------

  /** So many bodies, none of which touches another. */
  begin(count: number): void {
    this.count = count;
    for (let i = 0; i < count; i++) (this.#neighbours[i] ??= new Set()).clear();
    this.#changing.clear();
  }

  /** Blocks of this body are others in each factor. */
  changes(i: number): void {
    this.#changing.add(i);
  }

  connect(a: number, b: number): void {
    this.#neighbours[a]!.add(b);
    this.#neighbours[b]!.add(a);
  }

  /** Finds an order of elimination (that of the least degree) and what it fills in. False: it takes more than `most` products. */
  analyse(most: number): boolean {
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
      for (let q = 0; q < p; q++) this.connect(near[p]!, near[q]!);
  }

  #lay(columns: readonly number[][]): void {
    const total = columns.reduce((sum, { length }) => sum + length, 0);
    if (this.#rows.length < total) this.#rows = new Int32Array(2 * total);
    const room = (this.count + total) * BLOCK;
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
    const { onDiagonal, others } = this.#changingBlocks();
    const room = onDiagonal.length + others.length;
    if (this.#left.length < room) this.#left = new Float64Array(2 * room);
    this.#left.set(onDiagonal);
    this.#left.set(others, onDiagonal.length);
    return true;
  }

  /** Only what changes is to be added anew. */
  restore(): void {
    const { onDiagonal, others } = this.#changingBlocks();
    onDiagonal.set(this.#left.subarray(0, onDiagonal.length));
    others.set(this.#left.subarray(onDiagonal.length, onDiagonal.length + others.length));
  }

  #changingBlocks() {
    const { values, count } = this;
    const first = this.#firstChanging;
    return {
      onDiagonal: values.subarray(first * BLOCK, count * BLOCK),
      others: values.subarray(
        (count + this.#starts[first]!) * BLOCK,
        (count + this.#starts[count]!) * BLOCK,
      ),
    };
  }

  /** The rest, in place. False: not positive definite. */
  factor(): boolean {
    return this.#factor(this.#firstChanging, this.count, this.#constantProducts);
  }

  #factor(first: number, end: number, next: number): boolean {
    const { values, count } = this;
    const targets = this.#targets;
    for (let k = first; k < end; k++) {
      const diagonal = k * BLOCK;
      if (!factorBlock(values, diagonal)) return false;
      const from = this.#starts[k]!;
      const to = this.#starts[k + 1]!;
      for (let p = from; p < to; p++) divideBlock(values, (count + p) * BLOCK, diagonal);
      for (let p = from; p < to; p++)
        for (let q = from; q <= p; q++)
          takeProduct(values, targets[next++]!, (count + p) * BLOCK, (count + q) * BLOCK);
    }
    return true;
  }

  /** L Lᵀ x = b, in place; six numbers a body. */
  solve(x: Float64Array): void {
    const { values, count } = this;
    if (this.#permuted.length < SIZE * count) this.#permuted = new Float64Array(2 * SIZE * count);
    const y = this.#permuted;
    for (let i = 0; i < count; i++)
      for (let j = 0; j < SIZE; j++) y[this.#place[i]! * SIZE + j] = x[i * SIZE + j]!;
    for (let k = 0; k < count; k++) {
      forwardBlock(values, k * BLOCK, y, k * SIZE);
      for (let p = this.#starts[k]!; p < this.#starts[k + 1]!; p++)
        takeTimes(values, (count + p) * BLOCK, y, k * SIZE, this.#rows[p]! * SIZE);
    }
    for (let k = count - 1; k >= 0; k--) {
      for (let p = this.#starts[k]!; p < this.#starts[k + 1]!; p++)
        takeTransposedTimes(values, (count + p) * BLOCK, y, this.#rows[p]! * SIZE, k * SIZE);
      backwardBlock(values, k * BLOCK, y, k * SIZE);
    }
    for (let i = 0; i < count; i++)
      for (let j = 0; j < SIZE; j++) x[i * SIZE + j] = y[this.#place[i]! * SIZE + j]!;
  }
}

// ---- blocks -----------------------------------------------------------------------------------------------------------

/** Lower factor in place; its diagonal holds the inverse. */
function factorBlock(a: Float64Array, at: number): boolean {
  for (let j = 0; j < SIZE; j++) {
    const row = at + j * SIZE;
    let diagonal = a[row + j]!;
    for (let k = 0; k < j; k++) diagonal -= a[row + k]! * a[row + k]!;
    if (!(diagonal > 0)) return false;
    const inverse = 1 / Math.sqrt(diagonal);
    a[row + j] = inverse;
    for (let i = j + 1; i < SIZE; i++) {
      const other = at + i * SIZE;
      let sum = a[other + j]!;
      for (let k = 0; k < j; k++) sum -= a[other + k]! * a[row + k]!;
      a[other + j] = sum * inverse;
    }
  }
  return true;
}

/** A ← A L⁻ᵀ */
function divideBlock(a: Float64Array, at: number, l: number): void {
  for (let i = 0; i < SIZE; i++) {
    const row = at + i * SIZE;
    for (let j = 0; j < SIZE; j++) {
      let sum = a[row + j]!;
      for (let k = 0; k < j; k++) sum -= a[row + k]! * a[l + j * SIZE + k]!;
      a[row + j] = sum * a[l + j * SIZE + j]!;
    }
  }
}

/** A ← A - B Cᵀ. All that factoring costs is here: no loop inside, no array made. */
function takeProduct(v: Float64Array, a: number, b: number, c: number): void {
  for (let i = 0; i < SIZE; i++) {
    const p = b + i * SIZE;
    const p0 = v[p]!;
    const p1 = v[p + 1]!;
    const p2 = v[p + 2]!;
    const p3 = v[p + 3]!;
    const p4 = v[p + 4]!;
    const p5 = v[p + 5]!;
    const row = a + i * SIZE;
    let q = c;
    for (let j = 0; j < SIZE; j++, q += SIZE)
      v[row + j]! -=
        p0 * v[q]! +
        p1 * v[q + 1]! +
        p2 * v[q + 2]! +
        p3 * v[q + 3]! +
        p4 * v[q + 4]! +
        p5 * v[q + 5]!;
  }
}

function forwardBlock(l: Float64Array, at: number, x: Float64Array, from: number): void {
  for (let i = 0; i < SIZE; i++) {
    let sum = x[from + i]!;
    for (let k = 0; k < i; k++) sum -= l[at + i * SIZE + k]! * x[from + k]!;
    x[from + i] = sum * l[at + i * SIZE + i]!;
  }
}

function backwardBlock(l: Float64Array, at: number, x: Float64Array, from: number): void {
  for (let i = SIZE - 1; i >= 0; i--) {
    const value = x[from + i]! * l[at + i * SIZE + i]!;
    x[from + i] = value;
    for (let k = 0; k < i; k++) x[from + k]! -= l[at + i * SIZE + k]! * value;
  }
}

/** x[to] ← x[to] - A x[from] */
function takeTimes(a: Float64Array, at: number, x: Float64Array, from: number, to: number): void {
  for (let i = 0; i < SIZE; i++) {
    let sum = 0;
    for (let j = 0; j < SIZE; j++) sum += a[at + i * SIZE + j]! * x[from + j]!;
    x[to + i]! -= sum;
  }
}

/** x[to] ← x[to] - Aᵀ x[from] */
function takeTransposedTimes(
  a: Float64Array,
  at: number,
  x: Float64Array,
  from: number,
  to: number,
): void {
  for (let i = 0; i < SIZE; i++) {
    const value = x[from + i]!;
    for (let j = 0; j < SIZE; j++) x[to + j]! -= a[at + i * SIZE + j]! * value;
  }
}
