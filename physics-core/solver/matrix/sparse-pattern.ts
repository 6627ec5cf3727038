/** Nobody has looked at it since something changed. */
const UNKNOWN = -1;

/**
 * Where the Cholesky factor of a sparse symmetric matrix of blocks has blocks, found once for all matrices with such a
 * pattern: unknowns are eliminated in order of least degree (Tinney's second scheme), of several the one that fills in least:
 * in a net of 20 × 20 that takes 73,000 products of blocks, where the first of several takes 122,000.
 */
export class SparsePattern {
  readonly size: number;
  /** By elimination: which unknown it is; and by unknown: when it is eliminated. */
  readonly order: Int32Array;
  readonly place: Int32Array;
  /** Per column of the factor, its blocks below the diagonal: where they begin, and the row of each, all by elimination. */
  readonly starts: Int32Array;
  readonly rows: Int32Array;

  /** Whether the factor would take more products than it may; then nothing else here is filled in. */
  readonly tangled: boolean;

  /** `neighbours`: of each unknown, those it shares a block with; used up. `most`: products of blocks. */
  constructor(neighbours: Set<number>[], most = Infinity) {
    this.size = neighbours.length;
    this.order = new Int32Array(this.size);
    this.place = new Int32Array(this.size);
    const found = this.#eliminate(neighbours, most);
    this.tangled = !found;
    const columns = found ?? [];
    this.starts = new Int32Array(this.size + 1);
    columns.forEach((column, i) => (this.starts[i + 1] = this.starts[i]! + column.length));
    this.rows = Int32Array.from(columns.flatMap((column) => column));
  }

  /** Returns the rows of each column of the factor; undefined: they have more products than that. */
  #eliminate(neighbours: Set<number>[], most: number): number[][] | undefined {
    let products = 0;
    const left = new Set(neighbours.keys());
    const fill = new Int32Array(this.size).fill(UNKNOWN);
    const columns: number[][] = [];
    while (left.size > 0) {
      const next = leastOf(left, neighbours, fill);
      this.place[next] = columns.length;
      this.order[columns.length] = next;
      left.delete(next);
      const column = [...neighbours[next]!];
      columns.push(column);
      products += (column.length * (column.length + 1)) / 2;
      if (products > most) return undefined;
      for (const i of column) {
        const set = neighbours[i]!;
        set.delete(next);
        fill[i] = UNKNOWN;
        for (const k of set) fill[k] = UNKNOWN;
        for (const k of column) if (k !== i) set.add(k);
      }
    }
    return columns.map((column) => column.map((i) => this.place[i]!).sort((a, b) => a - b));
  }

  /**
   * From where the product of each pair of blocks of a column is taken, column by column, in a matrix whose diagonals and
   * blocks are at these places.
   */
  targets(diagonalAt: Int32Array, blockAt: Int32Array): Int32Array {
    const { starts, rows } = this;
    const targets: number[] = [];
    for (let j = 0; j < this.size; j++)
      for (let b = starts[j]!; b < starts[j + 1]!; b++) {
        targets.push(diagonalAt[rows[b]!]!);
        for (let a = b + 1; a < starts[j + 1]!; a++)
          targets.push(blockAt[this.#blockAt(rows[a]!, rows[b]!)]!);
      }
    return Int32Array.from(targets);
  }

  /** The block in a row and a column, by elimination. */
  #blockAt(row: number, column: number): number {
    let low = this.starts[column]!;
    let high = this.starts[column + 1]!;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.rows[middle]! <= row) low = middle;
      else high = middle;
    }
    return low;
  }

  /** The block that two unknowns share, and whether its rows are those of the first. */
  between(a: number, b: number): { block: number; straight: boolean } {
    const i = this.place[a]!;
    const j = this.place[b]!;
    return i >= j
      ? { block: this.#blockAt(i, j), straight: true }
      : { block: this.#blockAt(j, i), straight: false };
  }
}

/** The unknown of least degree; of several the first of those that fill in least. `fill`: as far as it is known. */
function leastOf(
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
