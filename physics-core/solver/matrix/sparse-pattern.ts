/** Nobody has looked at it since something changed. */
const UNKNOWN = -1;

/**
 * Where the Cholesky factor of a sparse symmetric matrix of blocks has blocks: the same for all matrices whose unknowns share
 * blocks in the same way. Arrays are kept from one search to the next.
 */
export class SparsePattern {
  /** Unknowns, and when each is eliminated. */
  size = 0;
  place = new Int32Array(16);
  /** Per column of the factor, its blocks below the diagonal: where they begin, and the row of each, all by elimination. */
  starts = new Int32Array(17);
  rows = new Int32Array(16);
  /** From which block the product of a block and each one below it is taken, column by column. */
  targets = new Int32Array(16);
  /** Of two blocks, what factoring takes, squares of blocks among them. */
  products = 0;

  /** All blocks below the diagonal. */
  get blocks(): number {
    return this.starts[this.size]!;
  }

  /**
   * In order of least degree (Tinney's second scheme), one group of unknowns after the other. `neighbours`: of each unknown,
   * those it shares a block with; used up, as groups are. `byFill`: of several the one that fills in least, which takes
   * longer to find: in a net of 20 × 20 it leaves 73,000 products, where the first of several leaves 122,000. False: more
   * products than `most`.
   */
  find(
    neighbours: Set<number>[],
    groups: readonly Set<number>[],
    most: number,
    byFill: boolean,
  ): boolean {
    this.size = groups.reduce((sum, { size }) => sum + size, 0);
    if (this.place.length < this.size) this.place = new Int32Array(2 * this.size);
    const fill = byFill ? new Int32Array(this.size).fill(UNKNOWN) : undefined;
    const columns: number[][] = [];
    this.products = 0;
    for (const left of groups)
      while (left.size > 0) {
        const next = fill ? leastFill(left, neighbours, fill) : leastDegree(left, neighbours);
        left.delete(next);
        this.place[next] = columns.length;
        const near = [...neighbours[next]!];
        columns.push(near);
        this.products += (near.length * (near.length + 1)) / 2;
        if (this.products > most) return false;
        eliminate(next, near, neighbours);
        if (fill) for (const i of near) for (const k of neighbours[i]!) fill[k] = fill[i] = UNKNOWN;
      }
    this.#lay(columns);
    return true;
  }

  #lay(columns: readonly number[][]): void {
    const blocks = columns.reduce((sum, { length }) => sum + length, 0);
    if (this.starts.length <= this.size) this.starts = new Int32Array(2 * this.size + 1);
    if (this.rows.length < blocks) this.rows = new Int32Array(2 * blocks);
    if (this.targets.length < this.products) this.targets = new Int32Array(2 * this.products);
    let at = 0;
    columns.forEach((near, k) => {
      this.starts[k] = at;
      for (const row of near.map((i) => this.place[i]!).sort((a, b) => a - b))
        this.rows[at++] = row;
    });
    this.starts[this.size] = at;
    let next = 0;
    for (let k = 0; k < this.size; k++)
      for (let b = this.starts[k]!; b < this.starts[k + 1]!; b++)
        for (let a = b + 1; a < this.starts[k + 1]!; a++)
          this.targets[next++] = this.#search(this.rows[a]!, this.rows[b]!);
  }

  /** The block of a row in a column, by elimination. */
  #search(row: number, column: number): number {
    let low = this.starts[column]!;
    let high = this.starts[column + 1]! - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle]! < row) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The block that two unknowns share; negative, less one: its rows are those of the second. */
  between(a: number, b: number): number {
    const i = this.place[a]!;
    const k = this.place[b]!;
    return i > k ? this.#search(i, k) : -1 - this.#search(k, i);
  }
}

/** What is left hangs together as if the unknown were still there. */
function eliminate(i: number, near: readonly number[], neighbours: readonly Set<number>[]): void {
  for (const a of near) {
    const set = neighbours[a]!;
    set.delete(i);
    for (const b of near) if (b !== a) set.add(b);
  }
}

/** The first unknown of least degree; one of at most 1 fills in nothing. */
function leastDegree(left: Iterable<number>, neighbours: readonly ReadonlySet<number>[]): number {
  let best = -1;
  let least = Infinity;
  for (const i of left) {
    const degree = neighbours[i]!.size;
    if (degree >= least) continue;
    best = i;
    least = degree;
    if (degree <= 1) break;
  }
  return best;
}

/** Of those of least degree the first that fills in least. `fill`: as far as it is known. */
function leastFill(
  left: Iterable<number>,
  neighbours: readonly ReadonlySet<number>[],
  fill: Int32Array,
): number {
  let degree = Infinity;
  for (const i of left) degree = Math.min(degree, neighbours[i]!.size);
  let next = -1;
  for (const i of left) {
    if (neighbours[i]!.size > degree) continue;
    if (fill[i] === UNKNOWN) fill[i] = fillOf(neighbours[i]!, neighbours);
    if (next < 0 || fill[i]! < fill[next]!) next = i;
  }
  return next;
}

/** How many pairs of its neighbours share no block yet. */
function fillOf(own: ReadonlySet<number>, neighbours: readonly ReadonlySet<number>[]): number {
  const near = [...own];
  let count = 0;
  near.forEach((a, i) => {
    for (let k = 0; k < i; k++) if (!neighbours[a]!.has(near[k]!)) count++;
  });
  return count;
}
