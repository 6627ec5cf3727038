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
  if (a >= 0) {
    const i = 6 * a;
    sum =
      sum +
      r[at]! * v[i]! +
      r[at + 1]! * v[i + 1]! +
      r[at + 2]! * v[i + 2]! +
      r[at + 3]! * v[i + 3]! +
      r[at + 4]! * v[i + 4]! +
      r[at + 5]! * v[i + 5]!;
  }
  if (b >= 0) {
    const i = 6 * b;
    sum =
      sum +
      r[at + 6]! * v[i]! +
      r[at + 7]! * v[i + 1]! +
      r[at + 8]! * v[i + 2]! +
      r[at + 9]! * v[i + 3]! +
      r[at + 10]! * v[i + 4]! +
      r[at + 11]! * v[i + 5]!;
  }
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
  if (a >= 0) takeSix(r, at + R.a, g, 6 * a, s);
  if (b >= 0) takeSix(r, at + R.b, g, 6 * b, s);
}

function takeSix(r: Float64Array, at: number, g: Float64Array, i: number, s: number): void {
  g[i]! -= s * r[at]!;
  g[i + 1]! -= s * r[at + 1]!;
  g[i + 2]! -= s * r[at + 2]!;
  g[i + 3]! -= s * r[at + 3]!;
  g[i + 4]! -= s * r[at + 4]!;
  g[i + 5]! -= s * r[at + 5]!;
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
  const a = r[i]!;
  const b = r[i + 1]!;
  const c = r[i + 2]!;
  const d = r[i + 3]!;
  const e = r[i + 4]!;
  const f = r[i + 5]!;
  const sb = s * b;
  const sc = s * c;
  const sd = s * d;
  const se = s * e;
  const sf = s * f;
  h[at]! += s * a * a;
  h[at + 6]! += sb * a;
  h[at + 7]! += sb * b;
  h[at + 12]! += sc * a;
  h[at + 13]! += sc * b;
  h[at + 14]! += sc * c;
  h[at + 18]! += sd * a;
  h[at + 19]! += sd * b;
  h[at + 20]! += sd * c;
  h[at + 21]! += sd * d;
  h[at + 24]! += se * a;
  h[at + 25]! += se * b;
  h[at + 26]! += se * c;
  h[at + 27]! += se * d;
  h[at + 28]! += se * e;
  h[at + 30]! += sf * a;
  h[at + 31]! += sf * b;
  h[at + 32]! += sf * c;
  h[at + 33]! += sf * d;
  h[at + 34]! += sf * e;
  h[at + 35]! += sf * f;
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
  const a = r[k]!;
  const b = r[k + 1]!;
  const c = r[k + 2]!;
  const d = r[k + 3]!;
  const e = r[k + 4]!;
  const f = r[k + 5]!;
  for (let x = 0, row = at; x < 6; x++, row += 6) {
    const value = s * r[i + x]!;
    h[row]! += value * a;
    h[row + 1]! += value * b;
    h[row + 2]! += value * c;
    h[row + 3]! += value * d;
    h[row + 4]! += value * e;
    h[row + 5]! += value * f;
  }
}
