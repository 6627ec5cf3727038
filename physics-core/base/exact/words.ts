// The two halves of a number in double precision, as integers; the low one first, as in every browser's memory.

const number = new Float64Array(1);
const words = new Int32Array(number.buffer);

/** Sign, exponent and the first bits. */
export function high(x: number): number {
  number[0] = x;
  return words[1]!;
}

export function low(x: number): number {
  number[0] = x;
  return words[0]!;
}

export function fromWords(high: number, low: number): number {
  words[0] = low;
  words[1] = high;
  return number[0]!;
}

/** Of the high word, without the sign. */
export const SIZE = 0x7fffffff;

/** 2 to a whole power from −1022 to 1023. */
export const twoTo = (power: number): number => fromWords((0x3ff + power) << 20, 0);
