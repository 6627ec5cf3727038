// After fdlibm's e_exp.c and e_log.c: see index.ts.
import { SIZE, fromWords, high, low, twoTo } from './words.js';

/** The logarithm of 2, and what its head leaves. */
export const LN2 = 6.9314718036912381649e-1;
export const LN2_LEFT = 1.9082149292705877e-10;
const PER_LN2 = 1.442695040888963387;

/** Half of ln 2, and one and a half of it. */
export const HALF_LN2 = 0x3fd62e42;
const MORE = 0x3ff0a2b2;

/** Without so many whole ln 2. */
export const whole = (x: number, word: number): number =>
  word < MORE ? Math.sign(x) : Math.trunc(PER_LN2 * x + (x < 0 ? -0.5 : 0.5));

export const LARGEST = 7.09782712893383973096e2;
const SMALLEST = -7.4513321910194110842e2;

/** Times 2 to a power, also where the power alone has no number. */
export function scaled(y: number, power: number): number {
  if (power === 1024) return y * 2 * twoTo(1023);
  return power >= -1021 ? y * twoTo(power) : y * twoTo(power + 1000) * 2 ** -1000;
}

export function exp(x: number): number {
  if (x > LARGEST) return Infinity;
  if (x < SMALLEST) return 0;
  if (x === 1) return Math.E;
  const word = high(x) & SIZE;
  if (word < 0x3e300000) return 1 + x;
  const power = word > HALF_LN2 ? whole(x, word) : 0;
  const head = x - power * LN2;
  const left = power * LN2_LEFT;
  const r = power ? head - left : x;
  const t = r * r;
  const c =
    r -
    t *
      (1.66666666666666019037e-1 +
        t *
          (-2.77777777770155933842e-3 +
            t *
              (6.61375632143793436117e-5 +
                t * (-1.6533902205465251539e-6 + t * 4.13813679705723846039e-8))));
  if (power === 0) return 1 - ((r * c) / (c - 2) - r);
  return scaled(1 - (left - (r * c) / (2 - c) - head), power);
}

/** A number as `share` times 2 to a power, the share about 1. */
function parted(x: number): { share: number; power: number; bits: number } {
  const small = high(x) < 0x00100000;
  const y = small ? x * 2 ** 54 : x;
  const bits = high(y) & 0xfffff;
  const up = (bits + 0x95f64) & 0x100000;
  const power = (high(y) >> 20) - 1023 + (up >> 20) - (small ? 54 : 0);
  return { share: fromWords(bits | (up ^ 0x3ff00000), low(y)), power, bits };
}

/** The natural logarithm. */
export function log(x: number): number {
  if (x === 0) return -Infinity;
  if (x < 0 || x !== x) return NaN;
  if (x === Infinity) return x;
  const { share, power, bits } = parted(x);
  const f = share - 1;
  const head = power * LN2;
  const left = power * LN2_LEFT;
  if ((0xfffff & (2 + bits)) < 3) {
    if (f === 0) return head + left;
    const r = f * f * (0.5 - (1 / 3) * f);
    return power === 0 ? f - r : head - (r - left - f);
  }
  const s = f / (2 + f);
  const r = logSeries(s * s);
  if (((bits - 0x6147a) | (0x6b851 - bits)) > 0) {
    const square = 0.5 * f * f;
    if (power === 0) return f - (square - s * (square + r));
    return head - (square - (s * (square + r) + left) - f);
  }
  return power === 0 ? f - s * (f - r) : head - (s * (f - r) - left - f);
}

function logSeries(z: number): number {
  const w = z * z;
  const even =
    w * (3.999999999940941908e-1 + w * (2.222219843214978396e-1 + w * 1.531383769920937332e-1));
  const odd =
    z *
    (6.66666666666673513e-1 +
      w * (2.857142874366239149e-1 + w * (1.818357216161805012e-1 + w * 1.479819860511658591e-1)));
  return odd + even;
}
