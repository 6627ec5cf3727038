/** Runs of points as triangles, each a list of indices into the points. */

const runsOf = (counts: number[]): number[][] => {
  let next = 0;
  return counts.map((count) => Array.from({ length: count }, () => next++));
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

export const fan = (run: number[]): number[] =>
  run.slice(2).flatMap((c, i) => [run[0]!, run[i + 1]!, c]);

const quads = (run: number[]): number[] =>
  run.flatMap((a, i) => (i % 4 ? [] : [a, run[i + 1]!, run[i + 2]!, a, run[i + 2]!, run[i + 3]!]));

/** The triangles of a set of strips, fans or quads; `lists`: counts of points, or indices. */
export function trianglesOf(type: string, lists: number[], pointCount: number): number[] {
  const whole = Array.from({ length: pointCount }, (_, i) => i);
  switch (type) {
    case 'TriangleStripSet':
      return runsOf(lists).flatMap(strip);
    case 'TriangleFanSet':
      return runsOf(lists).flatMap(fan);
    case 'QuadSet':
      return quads(whole.slice(0, pointCount - (pointCount % 4)));
    case 'IndexedTriangleStripSet':
      return listsOf(lists).flatMap(strip);
    case 'IndexedTriangleFanSet':
      return listsOf(lists).flatMap(fan);
    case 'IndexedQuadSet':
      return quads(lists.slice(0, lists.length - (lists.length % 4)));
    default:
      return whole;
  }
}
