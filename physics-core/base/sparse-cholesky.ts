import { backward, factor, forward, rowOf } from './cholesky.js';
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
    const { size, starts, rows, targets } = this.pattern;
    const sizes = this.#sizes;
    let target = 0;
    for (let j = 0; j < size; j++) {
      const n = sizes[j]!;
      const diagonal = this.#diagonalAt[j]!;
      if (!factor(this.numbers, diagonal, n)) return false;
      const end = starts[j + 1]!;
      for (let b = starts[j]!; b < end; b++) {
        const at = this.#blockAt[b]!;
        const height = sizes[rows[b]!]!;
        for (let r = 0; r < height; r++)
          forward(this.numbers, diagonal, n, this.numbers, at + r * n);
      }
      for (let b = starts[j]!; b < end; b++) {
        this.#reduceDiagonal(-1 - targets[target++]!, b, n);
        for (let a = b + 1; a < end; a++)
          this.#reduce(targets[target++]!, a, b, n, sizes[rows[a]!]!, sizes[rows[b]!]!);
      }
    }
    return true;
  }

  /** The triangle of row `i` -= block blockᵀ. */
  #reduceDiagonal(i: number, block: number, n: number): void {
    const l = this.numbers;
    const from = this.#blockAt[block]!;
    let to = this.#diagonalAt[i]!;
    for (let r = 0; r < this.#sizes[i]!; r++)
      for (let c = 0; c <= r; c++) {
        let sum = 0;
        for (let k = 0; k < n; k++) sum += l[from + r * n + k]! * l[from + c * n + k]!;
        l[to++]! -= sum;
      }
  }

  /** A block -= a bᵀ. */
  #reduce(target: number, a: number, b: number, n: number, height: number, width: number): void {
    const l = this.numbers;
    let to = this.#blockAt[target]!;
    let row = this.#blockAt[a]!;
    const first = this.#blockAt[b]!;
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
        for (let r = this.#firsts[i]!; r < this.#firsts[i + 1]!; r++)
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
        for (let r = this.#firsts[i]!; r < this.#firsts[i + 1]!; r++)
          for (let k = 0; k < n; k++) x[first + k]! -= l[at++]! * x[r]!;
      }
      backward(l, this.#diagonalAt[j]!, n, x, first);
    }
  }
}
