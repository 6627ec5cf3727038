// Symmetric 3 × 3 matrices inside flat arrays, nine numbers from an index on.

/** Passes of turns: each leaves the square of what was beside the diagonal (six leave less than rounding). */
const PASSES = 6;

const PLANES = [
  [0, 1],
  [0, 2],
  [1, 2],
] as const;

const diagonal = new Float64Array(9);
const axes = new Float64Array(9);

/** The nearest one without a negative principal value, in place: by turns to its principal axes (Jacobi). */
export function makeSemidefinite(m: Float64Array, at: number): void {
  for (let i = 0; i < 9; i++) {
    diagonal[i] = m[at + i]!;
    axes[i] = i % 4 === 0 ? 1 : 0;
  }
  for (let pass = 0; pass < PASSES; pass++) for (const [p, q] of PLANES) turn(p, q);
  for (let i = 0; i < 3; i++)
    for (let j = 0; j < 3; j++) {
      let sum = 0;
      for (let k = 0; k < 3; k++)
        sum += axes[3 * i + k]! * axes[3 * j + k]! * Math.max(0, diagonal[4 * k]!);
      m[at + 3 * i + j] = sum;
    }
}

/** In the plane of two axes, so that nothing is left beside the diagonal there. */
function turn(p: number, q: number): void {
  const beside = diagonal[3 * p + q]!;
  if (beside === 0) return;
  const half = (diagonal[4 * q]! - diagonal[4 * p]!) / (2 * beside);
  const tan = (half < 0 ? -1 : 1) / (Math.abs(half) + Math.sqrt(half * half + 1));
  const cos = 1 / Math.sqrt(tan * tan + 1);
  turnPair(diagonal, p, q, 3, cos, tan * cos);
  turnPair(diagonal, 3 * p, 3 * q, 1, cos, tan * cos);
  turnPair(axes, p, q, 3, cos, tan * cos);
}

/** Two rows or columns, whose numbers lie `step` apart. */
function turnPair(
  m: Float64Array,
  p: number,
  q: number,
  step: number,
  cos: number,
  sin: number,
): void {
  for (let k = 0; k < 3 * step; k += step) {
    const x = m[p + k]!;
    const y = m[q + k]!;
    m[p + k] = cos * x - sin * y;
    m[q + k] = sin * x + cos * y;
  }
}

/** Its inverse, by cofactors. */
export function invertSymmetric(m: Float64Array, out: Float64Array, at: number): void {
  const a = m[at]!;
  const b = m[at + 1]!;
  const c = m[at + 2]!;
  const d = m[at + 4]!;
  const e = m[at + 5]!;
  const f = m[at + 8]!;
  const share = 1 / (a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d));
  out[at] = share * (d * f - e * e);
  out[at + 1] = out[at + 3] = share * (c * e - b * f);
  out[at + 2] = out[at + 6] = share * (b * e - c * d);
  out[at + 4] = share * (a * f - c * c);
  out[at + 5] = out[at + 7] = share * (b * c - a * e);
  out[at + 8] = share * (a * d - b * b);
}
