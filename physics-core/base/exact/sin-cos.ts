// After fdlibm's k_sin.c, k_cos.c and e_rem_pio2.c: see index.ts.
import { SIZE, fromWords, high } from './words.js';

/** Up to an eighth of a turn; `tail` is what the angle's double leaves. */
function kernelSin(x: number, tail: number): number {
  if ((high(x) & SIZE) < 0x3e400000) return x;
  const z = x * x;
  const cube = z * x;
  const r =
    8.33333333332248946124e-3 +
    z *
      (-1.98412698298579493134e-4 +
        z *
          (2.75573137070700676789e-6 +
            z * (-2.50507602534068634195e-8 + z * 1.58969099521155010221e-10)));
  const third = -1.66666666666666324348e-1;
  if (tail === 0) return x + cube * (third + z * r);
  return x - (z * (0.5 * tail - cube * r) - tail - cube * third);
}

function kernelCos(x: number, tail: number): number {
  const word = high(x) & SIZE;
  if (word < 0x3e400000) return 1;
  const z = x * x;
  const r =
    z *
    (4.16666666666666019037e-2 +
      z *
        (-1.38888888888741095749e-3 +
          z *
            (2.48015872894767294178e-5 +
              z *
                (-2.75573143513906633035e-7 +
                  z * (2.0875723212981748279e-9 + z * -1.13596475577881948265e-11)))));
  if (word < 0x3fd33333) return 1 - (0.5 * z - (z * r - x * tail));
  const share = word > 0x3fe90000 ? 0.28125 : fromWords(word - 0x00200000, 0);
  return 1 - share - (0.5 * z - share - (z * r - x * tail));
}

const EIGHTH = 0x3fe921fb;
const QUARTER = 0x3ff921fb;
const THREE_EIGHTHS = 0x4002d97c;

/** A quarter of a turn in three parts, each with what it leaves. */
const PARTS = [
  [1.57079632673412561417, 6.07710050650619224932e-11],
  [6.0771005063039659766e-11, 2.02226624879595063154e-21],
  [2.0222662487111664558e-21, 8.47842766036889956997e-32],
] as const;
const QUARTERS_PER_RADIAN = 6.36619772367581382433e-1;

/** High words of the first multiples of a quarter. */
const MULTIPLES = Array.from({ length: 32 }, (_, i) => high(((i + 1) * Math.PI) / 2));

/** What is left of an angle without its whole quarters. */
let rest = 0;
let tail = 0;

function leave(from: number, less: number): void {
  rest = from - less;
  tail = from - rest - less;
}

/** Up to three eighths of a turn. */
function takeOne(x: number, word: number): void {
  const near = x - PARTS[0][0];
  if (word !== QUARTER) leave(near, PARTS[0][1]);
  else leave(near - PARTS[1][0], PARTS[1][1]);
}

const exponent = (word: number): number => (word >> 20) & 0x7ff;

function takeMany(x: number, word: number): number {
  const count = Math.trunc(x * QUARTERS_PER_RADIAN + 0.5);
  let from = x - count * PARTS[0][0];
  let less = count * PARTS[0][1];
  leave(from, less);
  if (count < 32 && word !== MULTIPLES[count - 1]) return count;
  for (const [part, lost] of [
    [1, 16],
    [2, 49],
  ] as const) {
    if (exponent(word) - exponent(high(rest)) <= lost) break;
    const before = from;
    less = count * PARTS[part][0];
    from = before - less;
    less = count * PARTS[part][1] - (before - from - less);
    leave(from, less);
  }
  return count;
}

/** Leaves an angle without its quarters of a turn, and answers their number. */
function takeQuarters(x: number): number {
  const word = high(x) & SIZE;
  const size = Math.abs(x);
  let count = 1;
  if (word < THREE_EIGHTHS) takeOne(size, word);
  else count = takeMany(size, word);
  if (x > 0) return count;
  rest = -rest;
  tail = -tail;
  return -count;
}

/** Beyond, quarters are more than these parts can take: the platform's own. */
const FARTHEST = 0x413921fb;

export function sin(x: number): number {
  const word = high(x) & SIZE;
  if (word <= EIGHTH) return kernelSin(x, 0);
  if (word > FARTHEST) return Math.sin(x);
  const quarter = takeQuarters(x) & 3;
  const value = quarter & 1 ? kernelCos(rest, tail) : kernelSin(rest, tail);
  return quarter & 2 ? -value : value;
}

export function cos(x: number): number {
  const word = high(x) & SIZE;
  if (word <= EIGHTH) return kernelCos(x, 0);
  if (word > FARTHEST) return Math.cos(x);
  const quarter = takeQuarters(x) & 3;
  const value = quarter & 1 ? kernelSin(rest, tail) : kernelCos(rest, tail);
  return quarter === 1 || quarter === 2 ? -value : value;
}
