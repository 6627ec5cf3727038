/** What changes while a particle lives. */
export interface Ramp {
  /** Whether anything of it may be seen through. */
  readonly fades: boolean;
  /** For each corner of a particle of that age, seconds. */
  write(age: number, out: Float32Array, at: number, corners: number): void;
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
  return {
    fades: colors.some((value, i) => i % RGBA === 3 && value < 1),
    write: (age, out, at, corners) => {
      const lower = keyAt(keys, age);
      const from = RGBA * lower;
      const next = keys[lower + 1];
      const share =
        next === undefined ? 0 : Math.max(0, (age - keys[lower]!) / (next - keys[lower]!));
      for (let i = 0; i < RGBA; i++) {
        const value = colors[from + i]!;
        const now = share > 0 ? value + share * (colors[from + RGBA + i]! - value) : value;
        for (let k = i; k < RGBA * corners; k += RGBA) out[at + k] = now;
      }
    },
  };
}

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
    write: (age, out, at) => {
      const from = keyAt(keys, age) * length;
      for (let i = 0; i < length; i++) out[at + i] = points[from + i]!;
    },
  };
}
