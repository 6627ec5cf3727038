/** Numbers of a velocity: linear and angular. */
export const SIDE = 6;
/** Rows a joint may have: the six of a 6-DoF, and two motors on rows that have stops. */
export const ROWS = 8;
/** Numbers of a body's inertia: its mass, and what resists turning about its centre of mass as a triangle. */
export const INERTIA = 7;
/** Triangles of a body, and of the rows of a joint; the rows of a joint as one body sees them. */
export const BODY_BLOCK = (SIDE * (SIDE + 1)) / 2;
export const JOINT_BLOCK = (ROWS * (ROWS + 1)) / 2;
export const ROW_BLOCK = ROWS * SIDE;

// A symmetric block is its lower triangle, row after row. The diagonal of a factor holds its inverse: what solving needs.

/** Where row `i` of a triangle begins. */
export const rowOf = (i: number): number => (i * (i + 1)) >> 1;

/** Cholesky factor of the triangle of `n` rows at `at`, in place. False: not positive definite. */
export function factorBlock(a: Float64Array, at: number, n: number): boolean {
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

/** Dot product of six numbers each. */
export function dot6(a: Float64Array, i: number, b: Float64Array, j: number): number {
  return (
    a[i]! * b[j]! +
    a[i + 1]! * b[j + 1]! +
    a[i + 2]! * b[j + 2]! +
    a[i + 3]! * b[j + 3]! +
    a[i + 4]! * b[j + 4]! +
    a[i + 5]! * b[j + 5]!
  );
}

/** `to` += s × `from`, six numbers. */
export function add6(to: Float64Array, i: number, from: Float64Array, j: number, s: number): void {
  to[i]! += s * from[j]!;
  to[i + 1]! += s * from[j + 1]!;
  to[i + 2]! += s * from[j + 2]!;
  to[i + 3]! += s * from[j + 3]!;
  to[i + 4]! += s * from[j + 4]!;
  to[i + 5]! += s * from[j + 5]!;
}

/** `to` = `from`, six numbers. */
export function copy6(to: Float64Array, i: number, from: Float64Array, j: number): void {
  to[i] = from[j]!;
  to[i + 1] = from[j + 1]!;
  to[i + 2] = from[j + 2]!;
  to[i + 3] = from[j + 3]!;
  to[i + 4] = from[j + 4]!;
  to[i + 5] = from[j + 5]!;
}
