/** What each points at. */
export type Graph = Map<string, Set<string>>;

/** Everything from which each can be reached again, largest first (strongly connected components, by Tarjan). */
export function circlesOf(graph: Graph): string[][] {
  const found: string[][] = [];
  const indices = new Map<string, number>();
  const lowest = new Map<string, number>();
  const stack: string[] = [];

  const visit = (at: string): void => {
    const index = indices.size;
    indices.set(at, index);
    lowest.set(at, index);
    stack.push(at);
    for (const next of graph.get(at) ?? []) {
      if (!indices.has(next)) {
        visit(next);
        lowest.set(at, Math.min(lowest.get(at)!, lowest.get(next)!));
      } else if (stack.includes(next)) {
        lowest.set(at, Math.min(lowest.get(at)!, indices.get(next)!));
      }
    }
    if (lowest.get(at) === index) {
      const circle = stack.splice(stack.indexOf(at));
      if (circle.length > 1) found.push(circle.sort());
    }
  };

  for (const at of graph.keys()) if (!indices.has(at)) visit(at);
  return found.sort((a, b) => b.length - a.length);
}
