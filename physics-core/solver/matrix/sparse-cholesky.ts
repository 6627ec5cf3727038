import { backward, factor, forward, rowOf } from '../../base/cholesky.js';
import { divideRows, factorPoints, POINT, solvePoints } from './point-blocks.js';
import type { SparsePattern } from './sparse-pattern.js';

/**
 * The Cholesky factor of a sparse symmetric matrix of blocks. Diagonal blocks are triangles as `cholesky.ts` has them;
 * those below are full, row after row.
 */
export class SparseCholesky {
  readonly pattern: SparsePattern;
  /** Rows of each block of unknowns, by elimination, and where they begin in a vector. */
  readonly #sizes: Int32Array;
  readonly #firsts: Int32Array;
  readonly #diagonalAt: Int32Array;
  readonly #blockAt: Int32Array;
  /** Where the products of each pair of blocks of a column are taken from. */
  readonly #targets: Int32Array;
  /** All its blocks have three rows. */
  readonly #ofPoints: boolean;
  readonly numbers: Float64Array;
  readonly #vector: Float64Array;

  /** `sizes`: rows of each unknown. */
  constructor(pattern: SparsePattern, sizes: readonly number[]) {
    this.pattern = pattern;
    const { size, order, starts, rows } = pattern;
    this.#sizes = Int32Array.from(order, (unknown) => sizes[unknown]!);
    this.#firsts = new Int32Array(size + 1);
    this.#diagonalAt = new Int32Array(size);
    this.#blockAt = new Int32Array(rows.length);
    let room = 0;
    for (let j = 0; j < size; j++) {
      const n = this.#sizes[j]!;
      this.#firsts[j + 1] = this.#firsts[j]! + n;
      this.#diagonalAt[j] = room;
      room += rowOf(n);
      for (let b = starts[j]!; b < starts[j + 1]!; b++) {
        this.#blockAt[b] = room;
        room += n * this.#sizes[rows[b]!]!;
      }
    }
    this.#targets = pattern.targets(this.#diagonalAt, this.#blockAt);
    this.#ofPoints = this.#sizes.every((rows) => rows === POINT);
    this.numbers = new Float64Array(room);
    this.#vector = new Float64Array(this.#firsts[size]!);
  }

  /** Where the triangle of an unknown, or a block below the diagonal, begins in `numbers`. */
  diagonal(unknown: number): number {
    return this.#diagonalAt[this.pattern.place[unknown]!]!;
  }

  block(block: number): number {
    return this.#blockAt[block]!;
  }

  /** In place. False: not positive definite. */
  factor(): boolean {
    const { size, starts, rows } = this.pattern;
    const sizes = this.#sizes;
    const targets = this.#targets;
    if (this.#ofPoints) return factorPoints(this.numbers, this.pattern, this.#diagonalAt, targets);
    let target = 0;
    for (let j = 0; j < size; j++) {
      const n = sizes[j]!;
      const diagonal = this.#diagonalAt[j]!;
      if (!factor(this.numbers, diagonal, n)) return false;
      const end = starts[j + 1]!;
      for (let b = starts[j]!; b < end; b++) {
        const at = this.#blockAt[b]!;
        const last = at + sizes[rows[b]!]! * n;
        if (n === POINT) divideRows(this.numbers, diagonal, at, last);
        else for (let r = at; r < last; r += n) forward(this.numbers, diagonal, n, this.numbers, r);
      }
      for (let b = starts[j]!; b < end; b++) {
        this.#reduceDiagonal(targets[target++]!, b, n, sizes[rows[b]!]!);
        for (let a = b + 1; a < end; a++)
          this.#reduce(targets[target++]!, a, b, n, sizes[rows[a]!]!, sizes[rows[b]!]!);
      }
    }
    return true;
  }

  /** The triangle at `to` -= block blockᵀ. */
  #reduceDiagonal(to: number, block: number, n: number, height: number): void {
    const l = this.numbers;
    const from = this.#blockAt[block]!;
    for (let r = 0; r < height; r++)
      for (let c = 0; c <= r; c++) {
        let sum = 0;
        for (let k = 0; k < n; k++) sum += l[from + r * n + k]! * l[from + c * n + k]!;
        l[to++]! -= sum;
      }
  }

  /** The block at `to` -= a bᵀ. */
  #reduce(to: number, a: number, b: number, n: number, height: number, width: number): void {
    const l = this.numbers;
    let row = this.#blockAt[a]!;
    const first = this.#blockAt[b]!;
    if (n === POINT) return reducePoints(l, to, row, row + height * n, first, first + width * n);
    for (let r = 0; r < height; r++, row += n) {
      let column = first;
      for (let c = 0; c < width; c++, column += n) {
        let sum = 0;
        for (let k = 0; k < n; k++) sum += l[row + k]! * l[column + k]!;
        l[to++]! -= sum;
      }
    }
  }

  // ---- solving --------------------------------------------------------------------------------------------------------

  /** The numbers of an unknown on the right hand side, and once solved those of the solution: where they begin in `vector`. */
  at(unknown: number): number {
    return this.#firsts[this.pattern.place[unknown]!]!;
  }

  get vector(): Float64Array {
    return this.#vector;
  }

  /** L Lᵀ x = b, in place. */
  solve(): void {
    if (this.#ofPoints)
      return solvePoints(this.numbers, this.pattern, this.#diagonalAt, this.#vector);
    this.#forward();
    this.#backward();
  }

  #forward(): void {
    const { size, starts, rows } = this.pattern;
    const l = this.numbers;
    const x = this.#vector;
    for (let j = 0; j < size; j++) {
      const n = this.#sizes[j]!;
      const first = this.#firsts[j]!;
      forward(l, this.#diagonalAt[j]!, n, x, first);
      for (let b = starts[j]!; b < starts[j + 1]!; b++) {
        const i = rows[b]!;
        let at = this.#blockAt[b]!;
        const last = this.#firsts[i + 1]!;
        if (n === POINT) takeRows(l, at, x, this.#firsts[i]!, last, first);
        else
          for (let r = this.#firsts[i]!; r < last; r++)
            for (let k = 0; k < n; k++) x[r]! -= l[at++]! * x[first + k]!;
      }
    }
  }

  #backward(): void {
    const { size, starts, rows } = this.pattern;
    const l = this.numbers;
    const x = this.#vector;
    for (let j = size - 1; j >= 0; j--) {
      const n = this.#sizes[j]!;
      const first = this.#firsts[j]!;
      for (let b = starts[j]!; b < starts[j + 1]!; b++) {
        const i = rows[b]!;
        let at = this.#blockAt[b]!;
        const last = this.#firsts[i + 1]!;
        if (n === POINT) takeColumns(l, at, x, this.#firsts[i]!, last, first);
        else
          for (let r = this.#firsts[i]!; r < last; r++)
            for (let k = 0; k < n; k++) x[first + k]! -= l[at++]! * x[r]!;
      }
      backward(l, this.#diagonalAt[j]!, n, x, first);
    }
  }
}

/** x -= block y: its rows from `row` to `end` of x, the three numbers of y from `first` on. */
function takeRows(
  l: Float64Array,
  at: number,
  x: Float64Array,
  row: number,
  end: number,
  first: number,
): void {
  const a = x[first]!;
  const b = x[first + 1]!;
  const c = x[first + 2]!;
  for (; row < end; row++, at += POINT)
    x[row] = x[row]! - l[at]! * a - l[at + 1]! * b - l[at + 2]! * c;
}

/** y -= blockᵀ x, likewise. */
function takeColumns(
  l: Float64Array,
  at: number,
  x: Float64Array,
  row: number,
  end: number,
  first: number,
): void {
  let a = x[first]!;
  let b = x[first + 1]!;
  let c = x[first + 2]!;
  for (; row < end; row++, at += POINT) {
    const value = x[row]!;
    a -= l[at]! * value;
    b -= l[at + 1]! * value;
    c -= l[at + 2]! * value;
  }
  x[first] = a;
  x[first + 1] = b;
  x[first + 2] = c;
}

/** A block -= a bᵀ, of three columns each: `a` from `row` to `end`, `b` from `first` to `last`. */
function reducePoints(
  l: Float64Array,
  to: number,
  row: number,
  end: number,
  first: number,
  last: number,
): void {
  for (; row < end; row += POINT) {
    const x = l[row]!;
    const y = l[row + 1]!;
    const z = l[row + 2]!;
    for (let c = first; c < last; c += POINT) l[to++]! -= x * l[c]! + y * l[c + 1]! + z * l[c + 2]!;
  }
}
