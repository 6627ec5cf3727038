/** Numbers of a velocity: linear and angular. */
export const SIDE = 6;
/** Rows a joint may have: the six of a 6-DoF, and two motors on rows that have stops. */
export const ROWS = 8;
/** 6 × 6 of a body; the rows of a joint as one body sees them; the rows' own matrix. */
export const BODY_BLOCK = SIDE * SIDE;
export const ROW_BLOCK = ROWS * SIDE;
export const JOINT_BLOCK = ROWS * ROWS;

// Blocks are n × n with rows `side` numbers apart. The diagonal of a factor holds its inverse: what solving needs.

/** Cholesky factor of the block at `at`, in place; only the lower half is read. False: not positive definite. */
export function factorBlock(a: Float64Array, at: number, n: number, side: number): boolean {
  for (let j = 0; j < n; j++) {
    const row = at + j * side;
    let diagonal = a[row + j]!;
    for (let k = 0; k < j; k++) diagonal -= a[row + k]! * a[row + k]!;
    if (!(diagonal > 0)) return false;
    const inverse = 1 / Math.sqrt(diagonal);
    a[row + j] = inverse;
    for (let i = j + 1; i < n; i++) {
      const other = at + i * side;
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
  side: number,
  x: Float64Array,
  from: number,
): void {
  for (let i = 0; i < n; i++) {
    const row = at + i * side;
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
  side: number,
  x: Float64Array,
  from: number,
): void {
  for (let i = n - 1; i >= 0; i--) {
    let sum = x[from + i]!;
    for (let k = i + 1; k < n; k++) sum -= l[at + k * side + i]! * x[from + k]!;
    x[from + i] = sum * l[at + i * side + i]!;
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
  for (let x = 0; x < SIDE; x++) to[i + x]! += s * from[j + x]!;
}
