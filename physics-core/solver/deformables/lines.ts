import { STRAIGHT_ON } from '../tolerances.js';
import type { Edge } from './edges.js';

/** Threads of a surface, one after the other along each line in which they go on: oriented, and where each line begins. */
export interface Lines {
  readonly first: number[];
  readonly second: number[];
  /** Which edge each is. */
  readonly edges: Edge[];
  /** Of each line its first thread; at the end how many there are. */
  readonly starts: number[];
}

/** Each thread belongs to one line; at each point those go on in each other that lie straightest. */
export function linesOf(places: ArrayLike<number>, edges: readonly Edge[]): Lines {
  const threads = edges.filter(({ thread, length }) => thread && length > 0);
  const next = continuations(places, threads);
  const lines: Lines = { first: [], second: [], edges: [], starts: [0] };
  const taken = new Set<Edge>();
  const walk = (edge: Edge, from: number): void => {
    let now: Edge | undefined = edge;
    let at = from;
    while (now && !taken.has(now)) {
      taken.add(now);
      const to: number = now.a === at ? now.b : now.a;
      lines.first.push(at);
      lines.second.push(to);
      lines.edges.push(now);
      now = next.get(now)?.get(to);
      at = to;
    }
    lines.starts.push(lines.first.length);
  };
  // From their ends; then those that have none.
  for (const edge of threads)
    for (const end of [edge.a, edge.b])
      if (!taken.has(edge) && !next.get(edge)?.has(end)) walk(edge, end);
  for (const edge of threads) if (!taken.has(edge)) walk(edge, edge.a);
  return lines;
}

/** Of each thread, and each of its ends, which one goes on there. */
function continuations(
  places: ArrayLike<number>,
  threads: readonly Edge[],
): Map<Edge, Map<number, Edge>> {
  const around = new Map<number, Edge[]>();
  for (const edge of threads)
    for (const end of [edge.a, edge.b]) {
      const known = around.get(end);
      if (known) known.push(edge);
      else around.set(end, [edge]);
    }
  const next = new Map<Edge, Map<number, Edge>>(threads.map((edge) => [edge, new Map()]));
  for (const [point, edges] of around)
    for (const [one, other] of straightest(places, point, edges)) {
      next.get(one)!.set(point, other);
      next.get(other)!.set(point, one);
    }
  return next;
}

function straightest(
  places: ArrayLike<number>,
  point: number,
  edges: readonly Edge[],
): [Edge, Edge][] {
  const ways = edges.map(({ a, b, length }) => {
    const to = a === point ? b : a;
    return [0, 1, 2].map((k) => (places[3 * to + k]! - places[3 * point + k]!) / length);
  });
  const pairs: [cosine: number, i: number, j: number][] = [];
  for (let i = 0; i < edges.length; i++)
    for (let j = i + 1; j < edges.length; j++) {
      const cosine = ways[i]!.reduce((sum, x, k) => sum + x * ways[j]![k]!, 0);
      if (cosine < STRAIGHT_ON) pairs.push([cosine, i, j]);
    }
  pairs.sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2]);
  const taken = new Set<number>();
  const out: [Edge, Edge][] = [];
  for (const [, i, j] of pairs) {
    if (taken.has(i) || taken.has(j)) continue;
    taken.add(i).add(j);
    out.push([edges[i]!, edges[j]!]);
  }
  return out;
}
