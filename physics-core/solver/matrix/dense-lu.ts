/** A full matrix, taken apart in place by rows with the largest pivots (Gauss). */
export class DenseLu {
  size = 0;
  matrix = new Float64Array(0);
  #order = new Int32Array(0);
  #column = new Float64Array(0);

  resize(size: number): void {
    this.size = size;
    if (this.matrix.length < size * size) {
      this.matrix = new Float64Array(size * size);
      this.#order = new Int32Array(size);
      this.#column = new Float64Array(size);
    }
    this.matrix.fill(0, 0, size * size);
  }

  factor(): void {
    const n = this.size;
    const m = this.matrix;
    for (let k = 0; k < n; k++) {
      let pivot = k;
      for (let i = k + 1; i < n; i++)
        if (Math.abs(m[i * n + k]!) > Math.abs(m[pivot * n + k]!)) pivot = i;
      this.#order[k] = pivot;
      if (pivot !== k)
        for (let j = 0; j < n; j++) {
          const one = m[k * n + j]!;
          m[k * n + j] = m[pivot * n + j]!;
          m[pivot * n + j] = one;
        }
      const inverse = 1 / m[k * n + k]!;
      for (let i = k + 1; i < n; i++) {
        const share = (m[i * n + k]! *= inverse);
        if (share !== 0) for (let j = k + 1; j < n; j++) m[i * n + j]! -= share * m[k * n + j]!;
      }
    }
  }

  /** In place of `v`. */
  solve(v: Float64Array): void {
    const n = this.size;
    const m = this.matrix;
    for (let k = 0; k < n; k++) {
      const pivot = this.#order[k]!;
      const one = v[k]!;
      v[k] = v[pivot]!;
      v[pivot] = one;
    }
    for (let i = 1; i < n; i++) for (let j = 0; j < i; j++) v[i]! -= m[i * n + j]! * v[j]!;
    for (let i = n - 1; i >= 0; i--) {
      for (let j = i + 1; j < n; j++) v[i]! -= m[i * n + j]! * v[j]!;
      v[i]! /= m[i * n + i]!;
    }
  }

  /** The block of the inverse that belongs to `width` rows and columns from `from` on, by rows. */
  inverseBlock(from: number, width: number, out: Float64Array): void {
    const column = this.#column;
    for (let c = 0; c < width; c++) {
      column.fill(0, 0, this.size);
      column[from + c] = 1;
      this.solve(column);
      for (let r = 0; r < width; r++) out[r * width + c] = column[from + r]!;
    }
  }
}
