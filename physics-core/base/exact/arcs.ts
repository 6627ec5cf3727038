// After fdlibm's s_atan.c and e_atan2.c: see index.ts.
import { SIZE, high } from './words.js';

export const EIGHTH = 7.85398163397448278999e-1;
/** A quarter of a turn, and what its double leaves. */
export const QUARTER = 1.570796326794896558;
export const QUARTER_LEFT = 6.12323399573676603587e-17;
const HALF = Math.PI;
const HALF_LEFT = 1.2246467991473532e-16;

/** atan 1/2, 1, 3/2 and ∞, and what their doubles leave. */
const ARCS = [4.63647609000806093515e-1, EIGHTH, 9.82793723247329054082e-1, QUARTER];
const ARCS_LEFT = [
  2.26987774529616870924e-17,
  3.06161699786838301793e-17,
  1.39033110312309984516e-17,
  QUARTER_LEFT,
];

/** (x − atan x) / x for small x. */
function atanShare(x: number): number {
  const z = x * x;
  const w = z * z;
  const odd =
    z *
    (3.33333333333329318027e-1 +
      w *
        (1.42857142725034663711e-1 +
          w *
            (9.09088713343650656196e-2 +
              w *
                (6.66107313738753120669e-2 +
                  w * (4.97687799461593236017e-2 + w * 1.62858201153657823623e-2)))));
  const even =
    w *
    (-1.99999999998764832476e-1 +
      w *
        (-1.1111110405462355788e-1 +
          w *
            (-7.69187620504482999495e-2 +
              w * (-5.83357013379057348645e-2 + w * -3.6531572744216915527e-2))));
  return odd + even;
}

/** Of a number that is not negative. */
function arc(x: number): number {
  const word = high(x);
  if (word >= 0x44100000) return ARCS[3]! + ARCS_LEFT[3]!;
  if (word < 0x3e400000) return x;
  if (word < 0x3fdc0000) return x - x * atanShare(x);
  const near = word < 0x3fe60000 ? 0 : word < 0x3ff30000 ? 1 : word < 0x40038000 ? 2 : 3;
  const off = offArc(x, near);
  return ARCS[near]! - (off * atanShare(off) - ARCS_LEFT[near]! - off);
}

/** The tangent of what an angle is beyond one of the arcs. */
function offArc(x: number, near: number): number {
  if (near === 0) return (2 * x - 1) / (2 + x);
  if (near === 1) return (x - 1) / (x + 1);
  if (near === 2) return (x - 1.5) / (1 + 1.5 * x);
  return -1 / x;
}

/** Of y and x, one of which is zero or infinite. */
function onAxes(y: number, x: number): number {
  const negative = high(x) < 0;
  if (y === 0 || (Math.abs(x) === Infinity && Math.abs(y) !== Infinity)) return negative ? HALF : 0;
  if (Math.abs(x) !== Infinity) return QUARTER;
  return negative ? 3 * EIGHTH : EIGHTH;
}

/** Between the positive x axis and a place with this x and a y that is not negative. */
function turnTo(y: number, x: number): number {
  if (y === 0 || x === 0 || y === Infinity || Math.abs(x) === Infinity) return onAxes(y, x);
  const steeper = (high(y) - (high(x) & SIZE)) >> 20;
  if (x > 0) return steeper > 60 ? QUARTER : arc(y / x);
  if (steeper > 60) return QUARTER;
  const angle = steeper < -60 ? 0 : arc(Math.abs(y / x));
  return HALF - (angle - HALF_LEFT);
}

export function atan2(y: number, x: number): number {
  if (x !== x || y !== y) return NaN;
  const angle = turnTo(Math.abs(y), x);
  return high(y) < 0 ? -angle : angle;
}
