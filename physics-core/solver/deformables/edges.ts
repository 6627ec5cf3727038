import { DIAGONAL } from '../tolerances.js';

/** An edge of a surface of triangles. */
export interface Edge {
  readonly a: number;
  readonly b: number;
  /** Of its triangles: numbers, and the points across from it. */
  readonly faces: number[];
  readonly across: number[];
  readonly length: number;
  /** Thread, or else a diagonal between threads. */
  thread: boolean;
}

/** All edges of triangles, in the order in which they are met. Triangles without three different points have none. */
export function edgesOf(places: ArrayLike<number>, triangles: ArrayLike<number>): Edge[] {
  const edges = new Map<number, Edge>();
  const points = places.length / 3;
  for (let f = 0; 3 * f + 2 < triangles.length; f++)
    for (let n = 0; n < 3; n++) {
      const [a, b, c] = [0, 1, 2].map((k) => triangles[3 * f + ((n + k) % 3)]!) as Three;
      const key = Math.min(a, b) * points + Math.max(a, b);
      const known = edges.get(key);
      if (known) {
        known.faces.push(f);
        known.across.push(c);
      } else
        edges.set(key, {
          a: Math.min(a, b),
          b: Math.max(a, b),
          faces: [f],
          across: [c],
          length: distance(places, a, b),
          thread: true,
        });
    }
  const all = [...edges.values()];
  for (const edge of all) edge.thread = !isDiagonal(edge, places);
  return all;
}

type Three = [number, number, number];

/** Longer than the others of both its triangles: what was cut into them was one square of threads. */
function isDiagonal({ a, b, across, length }: Edge, places: ArrayLike<number>): boolean {
  if (across.length !== 2) return false;
  for (const c of across)
    if (length < DIAGONAL * distance(places, a, c) || length < DIAGONAL * distance(places, b, c))
      return false;
  return true;
}

export function distance(places: ArrayLike<number>, a: number, b: number): number {
  let square = 0;
  for (let k = 0; k < 3; k++) square += (places[3 * b + k]! - places[3 * a + k]!) ** 2;
  return Math.sqrt(square);
}
