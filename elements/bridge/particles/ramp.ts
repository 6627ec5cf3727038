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

/** Between the keys around an age: the lower one, and how far it is to the next. */
function between(keys: readonly number[], age: number): [lower: number, share: number] {
  const next = keys.findIndex((key) => key > age);
  if (next < 0) return [keys.length - 1, 0];
  if (next === 0) return [0, 0];
  const [from, to] = [keys[next - 1]!, keys[next]!];
  return [next - 1, (age - from) / (to - from)];
}

/** As many keys as there are values for. */
const usable = (keys: readonly number[], count: number): number[] =>
  count > 0 ? keys.slice(0, count) : [];

/** Colours by age, evenly from one key to the next; without keys the first. */
export function colorsOf(given: Iterable<Color>, colorKey: readonly number[]): Ramp | undefined {
  const colors = Array.from(given, ({ r, g, b, a = 1 }) => [r, g, b, a]);
  if (colors.length === 0) return undefined;
  const keys = usable(colorKey, colors.length);
  return {
    fades: colors.some(([, , , alpha]) => alpha! < 1),
    write: (age, out, at, corners) => {
      const [lower, share] = keys.length > 0 ? between(keys, age) : [0, 0];
      const from = colors[lower]!;
      const to = colors[lower + 1] ?? from;
      for (let i = 0; i < 4 * corners; i++) {
        const value = from[i % 4]!;
        out[at + i] = value + share * (to[i % 4]! - value);
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
  const points = Array.from(given, ({ x, y }) => [x, y]);
  const flat = points.flat();
  const sets = Math.floor(points.length / corners);
  if (sets === 0) return undefined;
  const keys = usable(texCoordKey, sets);
  return {
    fades: false,
    write: (age, out, at) => {
      const set = keys.length > 0 ? between(keys, age)[0] : 0;
      for (let i = 0; i < 2 * corners; i++) out[at + i] = flat[2 * corners * set + i]!;
    },
  };
}
