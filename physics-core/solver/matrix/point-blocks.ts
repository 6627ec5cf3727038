import type { SparsePattern } from './sparse-pattern.js';

// A sparse matrix all of whose blocks have three rows, as those of joints that hold a point have: nets and chains. Blocks of
// a column lie one behind the other, after its triangle: they are gone through with no loop inside, and numbers that are used
// more than once stand in names of their own, which engines keep in registers. The sums are those of any matrix, in the same
// order.

/** Rows of a block, and numbers of its triangle and of a block. */
export const POINT = 3;
const TRIANGLE = 6;
const BLOCK = 9;

/**
 * The factor, in place. `diagonalAt`: where the triangle of each column begins; `targets`: from where the product of each
 * pair of blocks of a column is taken. False: not positive definite.
 */
export function factorPoints(
  l: Float64Array,
  { size, starts }: SparsePattern,
  diagonalAt: Int32Array,
  targets: Int32Array,
): boolean {
  let next = 0;
  for (let j = 0; j < size; j++) {
    const diagonal = diagonalAt[j]!;
    if (!factorTriangle(l, diagonal)) return false;
    const from = diagonal + TRIANGLE;
    const end = from + BLOCK * (starts[j + 1]! - starts[j]!);
    divideRows(l, diagonal, from, end);
    for (let at = from; at < end; at += BLOCK) next = takeProducts(l, at, end, targets, next);
  }
  return true;
}

function factorTriangle(l: Float64Array, at: number): boolean {
  const first = l[at]!;
  if (!(first > 0)) return false;
  const a = 1 / Math.sqrt(first);
  const b = l[at + 1]! * a;
  const d = l[at + 3]! * a;
  const second = l[at + 2]! - b * b;
  if (!(second > 0)) return false;
  const c = 1 / Math.sqrt(second);
  const e = (l[at + 4]! - d * b) * c;
  const third = l[at + 5]! - d * d - e * e;
  if (!(third > 0)) return false;
  l[at] = a;
  l[at + 1] = b;
  l[at + 2] = c;
  l[at + 3] = d;
  l[at + 4] = e;
  l[at + 5] = 1 / Math.sqrt(third);
  return true;
}

/** L y = x of three rows, for each three numbers from `from` to `end`, in place. */
export function divideRows(l: Float64Array, at: number, from: number, end: number): void {
  const a = l[at]!;
  const b = l[at + 1]!;
  const c = l[at + 2]!;
  const d = l[at + 3]!;
  const e = l[at + 4]!;
  const f = l[at + 5]!;
  for (let i = from; i < end; i += POINT) {
    const x = l[i]! * a;
    const y = (l[i + 1]! - b * x) * c;
    l[i] = x;
    l[i + 1] = y;
    l[i + 2] = (l[i + 2]! - d * x - e * y) * f;
  }
}

/** Takes the products of a block by itself and by those behind it from where they belong: nearly all that a factor costs. */
function takeProducts(
  l: Float64Array,
  at: number,
  end: number,
  targets: Int32Array,
  next: number,
): number {
  const a = l[at]!;
  const b = l[at + 1]!;
  const c = l[at + 2]!;
  const d = l[at + 3]!;
  const e = l[at + 4]!;
  const f = l[at + 5]!;
  const g = l[at + 6]!;
  const h = l[at + 7]!;
  const i = l[at + 8]!;
  const own = targets[next++]!;
  l[own]! -= a * a + b * b + c * c;
  l[own + 1]! -= d * a + e * b + f * c;
  l[own + 2]! -= d * d + e * e + f * f;
  l[own + 3]! -= g * a + h * b + i * c;
  l[own + 4]! -= g * d + h * e + i * f;
  l[own + 5]! -= g * g + h * h + i * i;
  for (let p = at + BLOCK; p < end; p += BLOCK) {
    const to = targets[next++]!;
    let x = l[p]!;
    let y = l[p + 1]!;
    let z = l[p + 2]!;
    l[to]! -= x * a + y * b + z * c;
    l[to + 1]! -= x * d + y * e + z * f;
    l[to + 2]! -= x * g + y * h + z * i;
    x = l[p + 3]!;
    y = l[p + 4]!;
    z = l[p + 5]!;
    l[to + 3]! -= x * a + y * b + z * c;
    l[to + 4]! -= x * d + y * e + z * f;
    l[to + 5]! -= x * g + y * h + z * i;
    x = l[p + 6]!;
    y = l[p + 7]!;
    z = l[p + 8]!;
    l[to + 6]! -= x * a + y * b + z * c;
    l[to + 7]! -= x * d + y * e + z * f;
    l[to + 8]! -= x * g + y * h + z * i;
  }
  return next;
}

/** L Lᵀ x = b, in place. */
export function solvePoints(
  l: Float64Array,
  { size, starts, rows }: SparsePattern,
  diagonalAt: Int32Array,
  x: Float64Array,
): void {
  for (let j = 0; j < size; j++) {
    const at = diagonalAt[j]!;
    const k = j * POINT;
    const a = x[k]! * l[at]!;
    const b = (x[k + 1]! - l[at + 1]! * a) * l[at + 2]!;
    const c = (x[k + 2]! - l[at + 3]! * a - l[at + 4]! * b) * l[at + 5]!;
    x[k] = a;
    x[k + 1] = b;
    x[k + 2] = c;
    const end = starts[j + 1]!;
    for (let p = starts[j]!, m = at + TRIANGLE; p < end; p++, m += BLOCK) {
      const to = rows[p]! * POINT;
      x[to] = x[to]! - l[m]! * a - l[m + 1]! * b - l[m + 2]! * c;
      x[to + 1] = x[to + 1]! - l[m + 3]! * a - l[m + 4]! * b - l[m + 5]! * c;
      x[to + 2] = x[to + 2]! - l[m + 6]! * a - l[m + 7]! * b - l[m + 8]! * c;
    }
  }
  for (let j = size - 1; j >= 0; j--) {
    const at = diagonalAt[j]!;
    const k = j * POINT;
    let a = x[k]!;
    let b = x[k + 1]!;
    let c = x[k + 2]!;
    const end = starts[j + 1]!;
    for (let p = starts[j]!, m = at + TRIANGLE; p < end; p++, m += BLOCK) {
      const from = rows[p]! * POINT;
      const u = x[from]!;
      const v = x[from + 1]!;
      const w = x[from + 2]!;
      a = a - l[m]! * u - l[m + 3]! * v - l[m + 6]! * w;
      b = b - l[m + 1]! * u - l[m + 4]! * v - l[m + 7]! * w;
      c = c - l[m + 2]! * u - l[m + 5]! * v - l[m + 8]! * w;
    }
    c = c * l[at + 5]!;
    b = (b - l[at + 4]! * c) * l[at + 2]!;
    x[k] = (a - l[at + 3]! * c - l[at + 1]! * b) * l[at]!;
    x[k + 1] = b;
    x[k + 2] = c;
  }
}
