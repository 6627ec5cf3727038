import type { Flat } from '../../shapes/cut/cut.js';

/** Unknowns of a body: its velocity, then its spin. */
export const SIX = 6;

/** Solves A x = b for six unknowns by elimination, with the largest pivot; b becomes x, and A is used up. */
export function solveSix(a: Flat, b: Flat): void {
  for (let column = 0; column < SIX; column++) {
    swap(a, b, column, pivotOf(a, column));
    for (let row = column + 1; row < SIX; row++) {
      const share = a[SIX * row + column]! / a[SIX * column + column]!;
      if (share === 0) continue;
      for (let k = column; k < SIX; k++)
        a[SIX * row + k] = a[SIX * row + k]! - share * a[SIX * column + k]!;
      b[row] = b[row]! - share * b[column]!;
    }
  }
  for (let row = SIX - 1; row >= 0; row--) {
    let sum = b[row]!;
    for (let k = row + 1; k < SIX; k++) sum -= a[SIX * row + k]! * b[k]!;
    b[row] = sum / a[SIX * row + row]!;
  }
}

function pivotOf(a: Flat, column: number): number {
  let best = column;
  for (let row = column + 1; row < SIX; row++)
    if (Math.abs(a[SIX * row + column]!) > Math.abs(a[SIX * best + column]!)) best = row;
  return best;
}

function swap(a: Flat, b: Flat, one: number, other: number): void {
  if (one === other) return;
  for (let k = 0; k < SIX; k++) {
    const kept = a[SIX * one + k]!;
    a[SIX * one + k] = a[SIX * other + k]!;
    a[SIX * other + k] = kept;
  }
  const kept = b[one]!;
  b[one] = b[other]!;
  b[other] = kept;
}
