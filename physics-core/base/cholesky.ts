// Symmetric matrices by their lower triangles only, row after row, anywhere in an array: many small ones in a step. The
// diagonal of a factor holds its inverse, which is what solving needs.

/** Where row `i` of a triangle begins. */
export const rowOf = (i: number): number => (i * (i + 1)) >> 1;

/** Cholesky factor of the triangle of `n` rows at `at`, in place. False: not positive definite. */
export function factor(a: Float64Array, at: number, n: number): boolean {
  for (let j = 0; j < n; j++) {
    const row = at + rowOf(j);
    let diagonal = a[row + j]!;
    for (let k = 0; k < j; k++) diagonal -= a[row + k]! * a[row + k]!;
    if (!(diagonal > 0)) return false;
    const inverse = 1 / Math.sqrt(diagonal);
    a[row + j] = inverse;
    for (let i = j + 1; i < n; i++) {
      const other = at + rowOf(i);
      let sum = a[other + j]!;
      for (let k = 0; k < j; k++) sum -= a[other + k]! * a[row + k]!;
      a[other + j] = sum * inverse;
    }
  }
  return true;
}

/** L y = x, in place. */
export function forward(
  l: Float64Array,
  at: number,
  n: number,
  x: Float64Array,
  from: number,
): void {
  let row = at;
  for (let i = 0; i < n; row += ++i) {
    let sum = x[from + i]!;
    for (let k = 0; k < i; k++) sum -= l[row + k]! * x[from + k]!;
    x[from + i] = sum * l[row + i]!;
  }
}

/** Lᵀ x = y, in place. */
export function backward(
  l: Float64Array,
  at: number,
  n: number,
  x: Float64Array,
  from: number,
): void {
  for (let i = n - 1; i >= 0; i--) {
    const row = at + rowOf(i);
    const value = x[from + i]! * l[row + i]!;
    x[from + i] = value;
    for (let k = 0; k < i; k++) x[from + k]! -= l[row + k]! * value;
  }
}
