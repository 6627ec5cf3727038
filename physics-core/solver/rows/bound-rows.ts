import { grown, grownInt } from '../../base/grown.js';

// Rows of joints that contacts act on: J v is to keep a rate, by an impulse between two bounds.

/** Places of a row's numbers. */
export const R = {
  /** As both bodies see it, six numbers each. */
  a: 0,
  b: 6,
  target: 12,
  penalty: 13,
  impulse: 14,
  least: 15,
  most: 16,
  pushed: 17,
  miss: 18,
  change: 19,
  size: 20,
} as const;

export class BoundRows {
  count = 0;
  values = new Float64Array(R.size * 16);
  a = new Int32Array(16);
  b = new Int32Array(16);

  /** Room for one more; returns where its numbers begin. */
  add(a: number, b: number): number {
    const i = this.count++;
    if (i === this.a.length) this.#grow();
    this.a[i] = a;
    this.b[i] = b;
    return i * R.size;
  }

  /** Impulses are to begin at none. */
  forget(rows: readonly number[]): void {
    for (const i of rows) this.values[i * R.size + R.impulse] = 0;
  }

  #grow(): void {
    const room = 2 * this.a.length;
    this.values = grown(this.values, R.size * room);
    this.a = grownInt(this.a, room);
    this.b = grownInt(this.b, room);
  }
}

/** J v */
export function rate(r: Float64Array, at: number, v: Float64Array, a: number, b: number): number {
  let sum = 0;
  if (a >= 0) for (let k = 0; k < 6; k++) sum += r[at + k]! * v[6 * a + k]!;
  if (b >= 0) for (let k = 0; k < 6; k++) sum += r[at + 6 + k]! * v[6 * b + k]!;
  return sum;
}

/** g ← g - s Jᵀ */
export function takeAlong(
  r: Float64Array,
  at: number,
  g: Float64Array,
  a: number,
  b: number,
  s: number,
): void {
  if (a >= 0) for (let k = 0; k < 6; k++) g[6 * a + k]! -= s * r[at + k]!;
  if (b >= 0) for (let k = 0; k < 6; k++) g[6 * b + k]! -= s * r[at + 6 + k]!;
}

/** What the row pushes at a rate that misses by `miss + s change`. */
export function clamp(r: Float64Array, at: number, s: number): void {
  const wanted =
    r[at + R.impulse]! - r[at + R.penalty]! * (r[at + R.miss]! + s * r[at + R.change]!);
  r[at + R.pushed] = Math.min(r[at + R.most]!, Math.max(r[at + R.least]!, wanted));
}

/** Whether it answers speeds: its push lies within its bounds. */
export const gives = (r: Float64Array, at: number): boolean =>
  r[at + R.pushed]! > r[at + R.least]! && r[at + R.pushed]! < r[at + R.most]!;

/** Whether it may ever do other than give. */
export const isBounded = (r: Float64Array, at: number): boolean =>
  r[at + R.least]! > -Infinity || r[at + R.most]! < Infinity;

/** H ← H + s jᵢᵀ jᵢ, of six numbers, its lower half. */
export function addSquare(
  h: Float64Array,
  at: number,
  r: Float64Array,
  i: number,
  s: number,
): void {
  for (let x = 0; x < 6; x++) {
    const value = s * r[i + x]!;
    if (value !== 0) for (let y = 0; y <= x; y++) h[at + 6 * x + y]! += value * r[i + y]!;
  }
}

/** H ← H + s jᵢᵀ jₖ, of six numbers each. */
export function addOuter(
  h: Float64Array,
  at: number,
  r: Float64Array,
  i: number,
  k: number,
  s: number,
): void {
  for (let x = 0; x < 6; x++) {
    const value = s * r[i + x]!;
    if (value !== 0) for (let y = 0; y < 6; y++) h[at + 6 * x + y]! += value * r[k + y]!;
  }
}
