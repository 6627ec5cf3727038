import { MOST_HALVINGS } from '../tolerances.js';

/** Points, and three of them for each triangle. */
interface Triangles {
  points: ArrayLike<number>;
  index: ArrayLike<number>;
}

/**
 * A surface whose triangles are divided where their sides are longer than `most` metres: each such side in its middle, for
 * both that share it, so that what is closed stays closed. As long as that makes no more than so many triangles.
 */
export function divided(
  points: ArrayLike<number>,
  index: ArrayLike<number>,
  most: number,
  count: number,
): Triangles {
  const places = Array.from(points);
  let triangles = Array.from(index);
  for (let round = 0; round < MOST_HALVINGS; round++) {
    const known = places.length;
    const finer = once(places, triangles, most);
    if (places.length === known || finer.length > 3 * count) break;
    triangles = finer;
  }
  return used(places, triangles);
}

/** Without points that are no corners. */
function used(places: readonly number[], triangles: readonly number[]): Triangles {
  const numbers = new Int32Array(places.length / 3).fill(-1);
  const points: number[] = [];
  const index = triangles.map((i) => {
    if (numbers[i]! < 0) {
      numbers[i] = points.length / 3;
      points.push(places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!);
    }
    return numbers[i]!;
  });
  return { points, index };
}

function once(places: number[], triangles: readonly number[], most: number): number[] {
  const out: number[] = [];
  const middles = new Map<number, number>();
  const points = places.length / 3;
  /** The number of the point in the middle of a side that is too long. */
  const middle = (a: number, b: number): number | undefined => {
    let square = 0;
    for (let k = 0; k < 3; k++) square += (places[3 * a + k]! - places[3 * b + k]!) ** 2;
    if (!(square > most * most)) return undefined;
    const key = Math.min(a, b) * points + Math.max(a, b);
    let number = middles.get(key);
    if (number === undefined) {
      middles.set(key, (number = places.length / 3));
      for (let k = 0; k < 3; k++) places.push((places[3 * a + k]! + places[3 * b + k]!) / 2);
    }
    return number;
  };
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const a = triangles[t]!;
    const b = triangles[t + 1]!;
    const c = triangles[t + 2]!;
    cut(out, [a, b, c], [middle(a, b), middle(b, c), middle(c, a)]);
  }
  return out;
}

/** A triangle with points in the middles of its sides, from each corner to the next: undefined, where there is none. */
function cut(
  out: number[],
  corners: readonly [number, number, number],
  middles: readonly (number | undefined)[],
): void {
  // Around it, from a side on that is whole and after which one is not: a fan from there has no triangle without area.
  const turn = [0, 1, 2].find(
    (k) => middles[(k + 2) % 3] === undefined && middles[k] !== undefined,
  );
  const [a, b, c] = [0, 1, 2].map((k) => corners[(k + (turn ?? 0)) % 3]!) as [
    number,
    number,
    number,
  ];
  const [ab, bc, ca] = [0, 1, 2].map((k) => middles[(k + (turn ?? 0)) % 3]);
  if (ab === undefined) out.push(a, b, c);
  else if (ca !== undefined) out.push(a, ab, ca, ab, b, bc!, bc!, c, ca, ab, bc!, ca);
  else if (bc !== undefined) out.push(a, ab, bc, ab, b, bc, a, bc, c);
  else out.push(a, ab, c, ab, b, c);
}

/** m³ inside: negative, where triangles look inward. */
export function volumeOf(points: ArrayLike<number>, index: ArrayLike<number>): number {
  const from = 3 * (index[0] ?? 0);
  let six = 0;
  for (let t = 0; t + 2 < index.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * index[t + k]!) as [number, number, number];
    const way = (p: number, k: number): number => points[p + k]! - points[from + k]!;
    for (let k = 0; k < 3; k++) {
      const l = (k + 1) % 3;
      const m = (k + 2) % 3;
      six += way(a, k) * (way(b, l) * way(c, m) - way(b, m) * way(c, l));
    }
  }
  return six / 6;
}
