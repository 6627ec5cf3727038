import type { Seen } from './seen.js';

/** What changes while a particle lives. */
export interface Ramp {
  /** Whether anything of it may be seen through. */
  readonly fades: boolean;
  /** Writes it for each corner of each particle, in the order in which they are drawn. */
  write(seen: Seen, corners: number, out: Float32Array): void;
}

export interface Color {
  r: number;
  g: number;
  b: number;
  a?: number;
}

export interface Point {
  x: number;
  y: number;
}

/** Which key holds at an age: the last that is not above it. */
function keyAt(keys: readonly number[], age: number): number {
  let lower = 0;
  while (lower + 1 < keys.length && keys[lower + 1]! <= age) lower++;
  return lower;
}

/** As many keys as there are values for; none: the first value holds. */
const usable = (keys: readonly number[], count: number): readonly number[] =>
  keys.length > 0 && count > 0 ? keys.slice(0, count) : [0];

const RGBA = 4;

/** Colours by age, evenly from one key to the next; without keys the first. */
export function colorsOf(given: Iterable<Color>, colorKey: readonly number[]): Ramp | undefined {
  const colors = Float32Array.from(Array.from(given, ({ r, g, b, a = 1 }) => [r, g, b, a]).flat());
  const count = colors.length / RGBA;
  if (count === 0) return undefined;
  const keys = usable(colorKey, count);
  const last = RGBA * (keys.length - 1);
  return {
    fades: colors.some((value, i) => i % RGBA === 3 && value < 1),
    write: ({ order, ages, count }, corners, out) => {
      let at = 0;
      for (let i = 0; i < count; i++) {
        const age = ages[order[i]!]!;
        const lower = keyAt(keys, age);
        const from = RGBA * lower;
        const to = Math.min(from + RGBA, last);
        const share = to > from ? shareOf(age, keys[lower]!, keys[lower + 1]!) : 0;
        const r = colors[from]! + share * (colors[to]! - colors[from]!);
        const g = colors[from + 1]! + share * (colors[to + 1]! - colors[from + 1]!);
        const b = colors[from + 2]! + share * (colors[to + 2]! - colors[from + 2]!);
        const a = colors[from + 3]! + share * (colors[to + 3]! - colors[from + 3]!);
        for (let corner = 0; corner < corners; corner++, at += RGBA) {
          out[at] = r;
          out[at + 1] = g;
          out[at + 2] = b;
          out[at + 3] = a;
        }
      }
    },
  };
}

/** How far an age is from one key to the next; before the first: not at all. */
const shareOf = (age: number, key: number, next: number): number =>
  age > key ? (age - key) / (next - key) : 0;

/** Sets of texture coordinates, one for each key, which hold until the next. */
export function texCoordsOf(
  given: Iterable<Point>,
  texCoordKey: readonly number[],
  corners: number,
): Ramp | undefined {
  const points = Float32Array.from(Array.from(given, ({ x, y }) => [x, y]).flat());
  const length = 2 * corners;
  const sets = Math.floor(points.length / length);
  if (sets === 0) return undefined;
  const keys = usable(texCoordKey, sets);
  return {
    fades: false,
    write: ({ order, ages, count }, _, out) => {
      let at = 0;
      for (let i = 0; i < count; i++) {
        const from = keyAt(keys, ages[order[i]!]!) * length;
        for (let k = 0; k < length; k++) out[at++] = points[from + k]!;
      }
    },
  };
}
