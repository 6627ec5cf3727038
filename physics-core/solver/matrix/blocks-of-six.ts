// Blocks of six rows and columns, row after row, in an array of numbers: all that a factor and a solve of `SparseCholesky` cost
// is here. Numbers that are used more than once stand in names of their own, which engines keep in registers, and what is short
// is written out: half of the time and less, with the same sums in the same order.

/** Rows of a block. */
export const SIZE = 6;
export const BLOCK = 36;

/** Lower factor in place; its diagonal holds the inverse. */
export function factorBlock(a: Float64Array, at: number): boolean {
  const m0 = a[at]!;
  if (!(m0 > 0)) return false;
  const d0 = 1 / Math.sqrt(m0);
  const l10 = a[at + 6]! * d0;
  const l20 = a[at + 12]! * d0;
  const l30 = a[at + 18]! * d0;
  const l40 = a[at + 24]! * d0;
  const l50 = a[at + 30]! * d0;
  const m1 = a[at + 7]! - l10 * l10;
  if (!(m1 > 0)) return false;
  const d1 = 1 / Math.sqrt(m1);
  const l21 = (a[at + 13]! - l20 * l10) * d1;
  const l31 = (a[at + 19]! - l30 * l10) * d1;
  const l41 = (a[at + 25]! - l40 * l10) * d1;
  const l51 = (a[at + 31]! - l50 * l10) * d1;
  const m2 = a[at + 14]! - l20 * l20 - l21 * l21;
  if (!(m2 > 0)) return false;
  const d2 = 1 / Math.sqrt(m2);
  const l32 = (a[at + 20]! - l30 * l20 - l31 * l21) * d2;
  const l42 = (a[at + 26]! - l40 * l20 - l41 * l21) * d2;
  const l52 = (a[at + 32]! - l50 * l20 - l51 * l21) * d2;
  const m3 = a[at + 21]! - l30 * l30 - l31 * l31 - l32 * l32;
  if (!(m3 > 0)) return false;
  const d3 = 1 / Math.sqrt(m3);
  const l43 = (a[at + 27]! - l40 * l30 - l41 * l31 - l42 * l32) * d3;
  const l53 = (a[at + 33]! - l50 * l30 - l51 * l31 - l52 * l32) * d3;
  const m4 = a[at + 28]! - l40 * l40 - l41 * l41 - l42 * l42 - l43 * l43;
  if (!(m4 > 0)) return false;
  const d4 = 1 / Math.sqrt(m4);
  const l54 = (a[at + 34]! - l50 * l40 - l51 * l41 - l52 * l42 - l53 * l43) * d4;
  const m5 = a[at + 35]! - l50 * l50 - l51 * l51 - l52 * l52 - l53 * l53 - l54 * l54;
  if (!(m5 > 0)) return false;
  a[at] = d0;
  a[at + 6] = l10;
  a[at + 7] = d1;
  a[at + 12] = l20;
  a[at + 13] = l21;
  a[at + 14] = d2;
  a[at + 18] = l30;
  a[at + 19] = l31;
  a[at + 20] = l32;
  a[at + 21] = d3;
  a[at + 24] = l40;
  a[at + 25] = l41;
  a[at + 26] = l42;
  a[at + 27] = l43;
  a[at + 28] = d4;
  a[at + 30] = l50;
  a[at + 31] = l51;
  a[at + 32] = l52;
  a[at + 33] = l53;
  a[at + 34] = l54;
  a[at + 35] = 1 / Math.sqrt(m5);
  return true;
}

/** A ← A L⁻ᵀ, for all rows between two places. */
export function divideRows(a: Float64Array, from: number, to: number, l: number): void {
  const l00 = a[l]!;
  const l10 = a[l + 6]!;
  const l11 = a[l + 7]!;
  const l20 = a[l + 12]!;
  const l21 = a[l + 13]!;
  const l22 = a[l + 14]!;
  const l30 = a[l + 18]!;
  const l31 = a[l + 19]!;
  const l32 = a[l + 20]!;
  const l33 = a[l + 21]!;
  const l40 = a[l + 24]!;
  const l41 = a[l + 25]!;
  const l42 = a[l + 26]!;
  const l43 = a[l + 27]!;
  const l44 = a[l + 28]!;
  const l50 = a[l + 30]!;
  const l51 = a[l + 31]!;
  const l52 = a[l + 32]!;
  const l53 = a[l + 33]!;
  const l54 = a[l + 34]!;
  const l55 = a[l + 35]!;
  for (let row = from; row < to; row += SIZE) {
    const x0 = a[row]! * l00;
    const x1 = (a[row + 1]! - x0 * l10) * l11;
    const x2 = (a[row + 2]! - x0 * l20 - x1 * l21) * l22;
    const x3 = (a[row + 3]! - x0 * l30 - x1 * l31 - x2 * l32) * l33;
    const x4 = (a[row + 4]! - x0 * l40 - x1 * l41 - x2 * l42 - x3 * l43) * l44;
    const x5 = (a[row + 5]! - x0 * l50 - x1 * l51 - x2 * l52 - x3 * l53 - x4 * l54) * l55;
    a[row] = x0;
    a[row + 1] = x1;
    a[row + 2] = x2;
    a[row + 3] = x3;
    a[row + 4] = x4;
    a[row + 5] = x5;
  }
}

/** A ← A - B Cᵀ, two rows at a time. */
export function takeProduct(v: Float64Array, a: number, b: number, c: number): void {
  for (let p = b, row = a; p < b + BLOCK; p += 2 * SIZE, row += 2 * SIZE) {
    const p0 = v[p]!;
    const p1 = v[p + 1]!;
    const p2 = v[p + 2]!;
    const p3 = v[p + 3]!;
    const p4 = v[p + 4]!;
    const p5 = v[p + 5]!;
    const q0 = v[p + 6]!;
    const q1 = v[p + 7]!;
    const q2 = v[p + 8]!;
    const q3 = v[p + 9]!;
    const q4 = v[p + 10]!;
    const q5 = v[p + 11]!;
    for (let q = c, to = row; q < c + BLOCK; q += SIZE, to++) {
      const c0 = v[q]!;
      const c1 = v[q + 1]!;
      const c2 = v[q + 2]!;
      const c3 = v[q + 3]!;
      const c4 = v[q + 4]!;
      const c5 = v[q + 5]!;
      v[to]! -= p0 * c0 + p1 * c1 + p2 * c2 + p3 * c3 + p4 * c4 + p5 * c5;
      v[to + SIZE]! -= q0 * c0 + q1 * c1 + q2 * c2 + q3 * c3 + q4 * c4 + q5 * c5;
    }
  }
}

/** A ← A - B Bᵀ, its lower half. */
export function takeSquare(v: Float64Array, a: number, b: number): void {
  for (let q = b, column = 0; q < b + BLOCK; q += SIZE, column++) {
    const q0 = v[q]!;
    const q1 = v[q + 1]!;
    const q2 = v[q + 2]!;
    const q3 = v[q + 3]!;
    const q4 = v[q + 4]!;
    const q5 = v[q + 5]!;
    for (let p = q, to = a + column * (SIZE + 1); p < b + BLOCK; p += SIZE, to += SIZE)
      v[to]! -=
        v[p]! * q0 +
        v[p + 1]! * q1 +
        v[p + 2]! * q2 +
        v[p + 3]! * q3 +
        v[p + 4]! * q4 +
        v[p + 5]! * q5;
  }
}

export function forwardBlock(l: Float64Array, at: number, x: Float64Array, from: number): void {
  const x0 = x[from]! * l[at]!;
  const x1 = (x[from + 1]! - l[at + 6]! * x0) * l[at + 7]!;
  const x2 = (x[from + 2]! - l[at + 12]! * x0 - l[at + 13]! * x1) * l[at + 14]!;
  const x3 = (x[from + 3]! - l[at + 18]! * x0 - l[at + 19]! * x1 - l[at + 20]! * x2) * l[at + 21]!;
  const x4 =
    (x[from + 4]! - l[at + 24]! * x0 - l[at + 25]! * x1 - l[at + 26]! * x2 - l[at + 27]! * x3) *
    l[at + 28]!;
  x[from + 5] =
    (x[from + 5]! -
      l[at + 30]! * x0 -
      l[at + 31]! * x1 -
      l[at + 32]! * x2 -
      l[at + 33]! * x3 -
      l[at + 34]! * x4) *
    l[at + 35]!;
  x[from] = x0;
  x[from + 1] = x1;
  x[from + 2] = x2;
  x[from + 3] = x3;
  x[from + 4] = x4;
}

export function backwardBlock(l: Float64Array, at: number, x: Float64Array, from: number): void {
  const x5 = x[from + 5]! * l[at + 35]!;
  const x4 = (x[from + 4]! - l[at + 34]! * x5) * l[at + 28]!;
  const x3 = (x[from + 3]! - l[at + 33]! * x5 - l[at + 27]! * x4) * l[at + 21]!;
  const x2 = (x[from + 2]! - l[at + 32]! * x5 - l[at + 26]! * x4 - l[at + 20]! * x3) * l[at + 14]!;
  const x1 =
    (x[from + 1]! - l[at + 31]! * x5 - l[at + 25]! * x4 - l[at + 19]! * x3 - l[at + 13]! * x2) *
    l[at + 7]!;
  x[from] =
    (x[from]! -
      l[at + 30]! * x5 -
      l[at + 24]! * x4 -
      l[at + 18]! * x3 -
      l[at + 12]! * x2 -
      l[at + 6]! * x1) *
    l[at]!;
  x[from + 1] = x1;
  x[from + 2] = x2;
  x[from + 3] = x3;
  x[from + 4] = x4;
  x[from + 5] = x5;
}

/** x of each row of a column ← x - A x[from], for the blocks A from `at` on. */
export function takeTimes(
  a: Float64Array,
  at: number,
  x: Float64Array,
  from: number,
  rows: Int32Array,
  first: number,
  end: number,
): void {
  const x0 = x[from]!;
  const x1 = x[from + 1]!;
  const x2 = x[from + 2]!;
  const x3 = x[from + 3]!;
  const x4 = x[from + 4]!;
  const x5 = x[from + 5]!;
  for (let p = first, row = at; p < end; p++) {
    const to = rows[p]! * SIZE;
    for (let i = to; i < to + SIZE; i++, row += SIZE)
      x[i]! -=
        0 +
        a[row]! * x0 +
        a[row + 1]! * x1 +
        a[row + 2]! * x2 +
        a[row + 3]! * x3 +
        a[row + 4]! * x4 +
        a[row + 5]! * x5;
  }
}

/** x[to] ← x[to] - Aᵀ x of each row of a column, for the blocks A from `at` on. */
export function takeTransposedTimes(
  a: Float64Array,
  at: number,
  x: Float64Array,
  to: number,
  rows: Int32Array,
  first: number,
  end: number,
): void {
  let x0 = x[to]!;
  let x1 = x[to + 1]!;
  let x2 = x[to + 2]!;
  let x3 = x[to + 3]!;
  let x4 = x[to + 4]!;
  let x5 = x[to + 5]!;
  for (let p = first, row = at; p < end; p++) {
    const from = rows[p]! * SIZE;
    for (let i = from; i < from + SIZE; i++, row += SIZE) {
      const value = x[i]!;
      x0 -= a[row]! * value;
      x1 -= a[row + 1]! * value;
      x2 -= a[row + 2]! * value;
      x3 -= a[row + 3]! * value;
      x4 -= a[row + 4]! * value;
      x5 -= a[row + 5]! * value;
    }
  }
  x[to] = x0;
  x[to + 1] = x1;
  x[to + 2] = x2;
  x[to + 3] = x3;
  x[to + 4] = x4;
  x[to + 5] = x5;
}
