// After fdlibm's s_expm1.c: see index.ts.
import { HALF_LN2, LARGEST, LN2, LN2_LEFT, scaled, whole } from './exponentials.js';
import { SIZE, fromWords, high, twoTo } from './words.js';

/** exp x − 1, also where x is small. */
export function expm1(x: number): number {
  const word = high(x) & SIZE;
  if (x > LARGEST) return Infinity;
  // Below −56 ln 2 nothing is left of it.
  if (x < 0 && word >= 0x4043687a) return -1;
  if (word < 0x3c900000) return x;
  const power = word > HALF_LN2 ? whole(x, word) : 0;
  const head = x - power * LN2;
  const left = power * LN2_LEFT;
  const r = power ? head - left : x;
  const half = 0.5 * r;
  const square = r * half;
  const series =
    1 +
    square *
      (-3.33333333333331316428e-2 +
        square *
          (1.58730158725481460165e-3 +
            square *
              (-7.93650757867487942473e-5 +
                square * (4.00821782732936239552e-6 + square * -2.01099218183624371326e-7))));
  const t = 3 - series * half;
  const e = square * ((series - t) / (6 - r * t));
  if (power === 0) return r - (r * e - square);
  const c = head - r - left;
  return timesPower(r, r * (e - c) - c - square, power);
}

/** (1 + r − e) 2 to the power, less 1. */
function timesPower(r: number, e: number, power: number): number {
  if (power === -1) return 0.5 * (r - e) - 0.5;
  if (power === 1) return r < -0.25 ? -2 * (e - (r + 0.5)) : 1 + 2 * (r - e);
  if (power <= -2 || power > 56) return scaled(1 - (e - r), power) - 1;
  if (power < 20) return (fromWords(0x3ff00000 - (0x200000 >> power), 0) - (e - r)) * twoTo(power);
  return (r - (e + twoTo(-power)) + 1) * twoTo(power);
}
