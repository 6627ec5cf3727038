// Full blocks of 6 × 6 inside one array, row after row; what is symmetric or a factor has numbers in its lower half alone. All
// that a solve costs is here: numbers that are used more than once stand in names of their own, which engines keep in
// registers, and what is short is written out: half of the time and less, with the same sums in the same order.

/** Rows of a block. */
export const SIZE = 6;
export const BLOCK = 36;

/** Lower factor in place; its diagonal holds the inverse. */
export function factorBlock(a: Float64Array, at: number): boolean {
  for (let j = 0; j < SIZE; j++) {
    const row = at + j * SIZE;
    let diagonal = a[row + j]!;
    for (let k = row; k < row + j; k++) diagonal -= a[k]! * a[k]!;
    if (!(diagonal > 0)) return false;
    const inverse = 1 / Math.sqrt(diagonal);
    a[row + j] = inverse;
    for (let other = row + SIZE; other < at + BLOCK; other += SIZE) {
      let sum = a[other + j]!;
      for (let k = 0; k < j; k++) sum -= a[other + k]! * a[row + k]!;
      a[other + j] = sum * inverse;
    }
  }
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
  for (let p = b, row = a; p < b + BLOCK; p += SIZE, row += SIZE) {
    const p0 = v[p]!;
    const p1 = v[p + 1]!;
    const p2 = v[p + 2]!;
    const p3 = v[p + 3]!;
    const p4 = v[p + 4]!;
    const p5 = v[p + 5]!;
    for (let q = b, to = row; q <= p; q += SIZE, to++)
      v[to]! -=
        p0 * v[q]! +
        p1 * v[q + 1]! +
        p2 * v[q + 2]! +
        p3 * v[q + 3]! +
        p4 * v[q + 4]! +
        p5 * v[q + 5]!;
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
