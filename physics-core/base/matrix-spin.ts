import { atan2, hypot } from './exact/index.js';

/** The spin, per second, that turns the matrix at `m[from]` into that at `m[to]` in so many seconds. */
export function writeSpin(
  out: Float64Array,
  at: number,
  m: Float64Array,
  from: number,
  to: number,
  seconds: number,
): void {
  // Twice the sine of the angle along the axis, from what is odd in to fromᵀ; the sum on its diagonal is 1 + 2 cos.
  let trace = 0;
  for (let i = 0; i < 3; i++) {
    const j = (i + 1) % 3;
    const k = (i + 2) % 3;
    let odd = 0;
    for (let c = 0; c < 3; c++) {
      odd += m[to + k * 3 + c]! * m[from + j * 3 + c]! - m[to + j * 3 + c]! * m[from + k * 3 + c]!;
      trace += m[to + i * 3 + c]! * m[from + i * 3 + c]!;
    }
    out[at + i] = odd;
  }
  const sine = hypot(out[at]!, out[at + 1]!, out[at + 2]!) / 2;
  const share = sine > 1e-12 ? atan2(sine, (trace - 1) / 2) / (2 * sine) : 0.5;
  for (let i = at; i < at + 3; i++) out[i]! *= share / seconds;
}
