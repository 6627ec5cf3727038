import fc from 'fast-check';
import type { World } from '../../physics-core/inside.js';

// Numbers of single precision and others, lists of them, turns.

/** In thousandths, so that they spread evenly and shrink to round ones. */
export const number = (low: number, high: number): fc.Arbitrary<number> =>
  fc
    .integer({ min: Math.ceil(low * 1000), max: Math.floor(high * 1000) })
    .map((thousandths) => thousandths / 1000);

/** Spread over the powers of ten. */
export const scale = (low: number, high: number): fc.Arbitrary<number> =>
  number(Math.log(low), Math.log(high)).map(Math.exp);

export const vector = (most: number): fc.Arbitrary<number[]> =>
  fc.tuple(number(-most, most), number(-most, most), number(-most, most));

export const turn = fc.tuple(number(-1, 1), number(-1, 1), number(-1, 1), number(-4, 4));

const NASTY_NUMBERS = [
  ...[0, -0, 1, -1, 1e-3, 1e-12, 1e-38, 1e-45, 5e-324, 1e3, 1e5, 1e7, 1e10, 1e15, -1e15, 1e20],
  ...[1e30, -1e30, 3.4e38, -3.4e38, 1e39, 1e300, NaN, Infinity, -Infinity, 2 ** 31 - 1, 2 ** 31],
];

export const nastyNumber = fc.constantFrom(...NASTY_NUMBERS);

/** Where all points of ropes, cloths and soft bodies are, by the numbers of their nodes. */
export const softPlaces = ({ nodes }: World): number[] =>
  [...nodes]
    .sort((a, b) => a.id - b.id)
    .flatMap((node) => [...((node as { places?: Float64Array }).places ?? [])]);
