// The triangles of six rows that say how bodies resist velocities, and their Cholesky factors: what `base/cholesky.ts` does
// for any number of rows, the same sums in the same order, written out.

/** Cholesky factor in place; its diagonal holds the inverse. False: not positive definite. */
export function factorBody(m: Float64Array, at: number): boolean {
  const m0 = m[at]!;
  if (!(m0 > 0)) return false;
  const d0 = 1 / Math.sqrt(m0);
  const l10 = m[at + 1]! * d0;
  const l20 = m[at + 3]! * d0;
  const l30 = m[at + 6]! * d0;
  const l40 = m[at + 10]! * d0;
  const l50 = m[at + 15]! * d0;
  const m1 = m[at + 2]! - l10 * l10;
  if (!(m1 > 0)) return false;
  const d1 = 1 / Math.sqrt(m1);
  const l21 = (m[at + 4]! - l20 * l10) * d1;
  const l31 = (m[at + 7]! - l30 * l10) * d1;
  const l41 = (m[at + 11]! - l40 * l10) * d1;
  const l51 = (m[at + 16]! - l50 * l10) * d1;
  const m2 = m[at + 5]! - l20 * l20 - l21 * l21;
  if (!(m2 > 0)) return false;
  const d2 = 1 / Math.sqrt(m2);
  const l32 = (m[at + 8]! - l30 * l20 - l31 * l21) * d2;
  const l42 = (m[at + 12]! - l40 * l20 - l41 * l21) * d2;
  const l52 = (m[at + 17]! - l50 * l20 - l51 * l21) * d2;
  const m3 = m[at + 9]! - l30 * l30 - l31 * l31 - l32 * l32;
  if (!(m3 > 0)) return false;
  const d3 = 1 / Math.sqrt(m3);
  const l43 = (m[at + 13]! - l40 * l30 - l41 * l31 - l42 * l32) * d3;
  const l53 = (m[at + 18]! - l50 * l30 - l51 * l31 - l52 * l32) * d3;
  const m4 = m[at + 14]! - l40 * l40 - l41 * l41 - l42 * l42 - l43 * l43;
  if (!(m4 > 0)) return false;
  const d4 = 1 / Math.sqrt(m4);
  const l54 = (m[at + 19]! - l50 * l40 - l51 * l41 - l52 * l42 - l53 * l43) * d4;
  const m5 = m[at + 20]! - l50 * l50 - l51 * l51 - l52 * l52 - l53 * l53 - l54 * l54;
  if (!(m5 > 0)) return false;
  m[at] = d0;
  m[at + 1] = l10;
  m[at + 2] = d1;
  m[at + 3] = l20;
  m[at + 4] = l21;
  m[at + 5] = d2;
  m[at + 6] = l30;
  m[at + 7] = l31;
  m[at + 8] = l32;
  m[at + 9] = d3;
  m[at + 10] = l40;
  m[at + 11] = l41;
  m[at + 12] = l42;
  m[at + 13] = l43;
  m[at + 14] = d4;
  m[at + 15] = l50;
  m[at + 16] = l51;
  m[at + 17] = l52;
  m[at + 18] = l53;
  m[at + 19] = l54;
  m[at + 20] = 1 / Math.sqrt(m5);
  return true;
}

/** L y = x, in place. */
export function forwardBody(l: Float64Array, at: number, x: Float64Array, i: number): void {
  const a = x[i]! * l[at]!;
  const b = (x[i + 1]! - l[at + 1]! * a) * l[at + 2]!;
  const c = (x[i + 2]! - l[at + 3]! * a - l[at + 4]! * b) * l[at + 5]!;
  const d = (x[i + 3]! - l[at + 6]! * a - l[at + 7]! * b - l[at + 8]! * c) * l[at + 9]!;
  const e =
    (x[i + 4]! - l[at + 10]! * a - l[at + 11]! * b - l[at + 12]! * c - l[at + 13]! * d) *
    l[at + 14]!;
  const f =
    (x[i + 5]! -
      l[at + 15]! * a -
      l[at + 16]! * b -
      l[at + 17]! * c -
      l[at + 18]! * d -
      l[at + 19]! * e) *
    l[at + 20]!;
  x[i] = a;
  x[i + 1] = b;
  x[i + 2] = c;
  x[i + 3] = d;
  x[i + 4] = e;
  x[i + 5] = f;
}

/** Lᵀ x = y, in place. */
export function backwardBody(l: Float64Array, at: number, x: Float64Array, i: number): void {
  const f = x[i + 5]! * l[at + 20]!;
  const e = (x[i + 4]! - l[at + 19]! * f) * l[at + 14]!;
  const d = (x[i + 3]! - l[at + 18]! * f - l[at + 13]! * e) * l[at + 9]!;
  const c = (x[i + 2]! - l[at + 17]! * f - l[at + 12]! * e - l[at + 8]! * d) * l[at + 5]!;
  const b =
    (x[i + 1]! - l[at + 16]! * f - l[at + 11]! * e - l[at + 7]! * d - l[at + 4]! * c) * l[at + 2]!;
  const a =
    (x[i]! - l[at + 15]! * f - l[at + 10]! * e - l[at + 6]! * d - l[at + 3]! * c - l[at + 1]! * b) *
    l[at]!;
  x[i] = a;
  x[i + 1] = b;
  x[i + 2] = c;
  x[i + 3] = d;
  x[i + 4] = e;
  x[i + 5] = f;
}

// ---- where nothing but its inertia resists a body: linear and angular velocity have nothing to do with each other ----

/** L y = x, in place, of such a body. */
export function forwardFree(l: Float64Array, at: number, x: Float64Array, i: number): void {
  const a = x[i + 3]! * l[at + 9]!;
  const b = (x[i + 4]! - l[at + 13]! * a) * l[at + 14]!;
  x[i] = x[i]! * l[at]!;
  x[i + 1] = x[i + 1]! * l[at + 2]!;
  x[i + 2] = x[i + 2]! * l[at + 5]!;
  x[i + 3] = a;
  x[i + 4] = b;
  x[i + 5] = (x[i + 5]! - l[at + 18]! * a - l[at + 19]! * b) * l[at + 20]!;
}

/** Lᵀ x = y, in place, of such a body. */
export function backwardFree(l: Float64Array, at: number, x: Float64Array, i: number): void {
  const c = x[i + 5]! * l[at + 20]!;
  const b = (x[i + 4]! - l[at + 19]! * c) * l[at + 14]!;
  x[i] = x[i]! * l[at]!;
  x[i + 1] = x[i + 1]! * l[at + 2]!;
  x[i + 2] = x[i + 2]! * l[at + 5]!;
  x[i + 3] = (x[i + 3]! - l[at + 18]! * c - l[at + 13]! * b) * l[at + 9]!;
  x[i + 4] = b;
  x[i + 5] = c;
}
