/** Runs of points as triangles, each a list of indices into the points. */
import { fan, trianglesOfFace } from './polygon.js';

/** Of no more points than there are. */
const runsOf = (counts: number[], points: number): number[][] => {
  let next = 0;
  return counts.map((count) =>
    Array.from({ length: Math.min(count, points - next) }, () => next++),
  );
};

/** Lists that -1 ends. */
export function listsOf(index: number[]): number[][] {
  const lists: number[][] = [[]];
  for (const i of index) {
    if (i < 0) lists.push([]);
    else lists.at(-1)!.push(i);
  }
  return lists;
}

/** Every second triangle of a strip turns the other way round. */
const strip = (run: number[]): number[] =>
  run.slice(2).flatMap((c, i) => {
    const [a, b] = [run[i]!, run[i + 1]!];
    return i % 2 ? [b, a, c] : [a, b, c];
  });

/** Each four that are whole. */
const quads = (points: number[], run: number[]): number[] =>
  run.flatMap((_, i) =>
    i % 4 || i + 4 > run.length ? [] : trianglesOfFace(points, run.slice(i, i + 4)),
  );

/** The triangles of a set of strips, fans or quads; `lists`: counts of points, or indices. */
export function trianglesOf(type: string, lists: number[], points: number[]): number[] {
  const whole = Array.from({ length: points.length / 3 }, (_, i) => i);
  switch (type) {
    case 'TriangleStripSet':
      return runsOf(lists, whole.length).flatMap(strip);
    case 'TriangleFanSet':
      return runsOf(lists, whole.length).flatMap(fan);
    case 'QuadSet':
      return quads(points, whole);
    case 'IndexedTriangleStripSet':
      return listsOf(lists).flatMap(strip);
    case 'IndexedTriangleFanSet':
      return listsOf(lists).flatMap(fan);
    case 'IndexedQuadSet':
      return quads(points, lists);
    default:
      return whole;
  }
}
