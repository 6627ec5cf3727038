/** Points in one place are one: which each is, and the places of those. */
export function weld(points: ArrayLike<number>): { places: number[]; carriers: number[] } {
  const known = new Map<string, number>();
  const places: number[] = [];
  const carriers: number[] = [];
  for (let i = 0; i + 2 < points.length; i += 3) {
    const key = `${points[i]! + 0} ${points[i + 1]! + 0} ${points[i + 2]! + 0}`;
    let at = known.get(key);
    if (at === undefined) {
      at = places.length / 3;
      known.set(key, at);
      places.push(points[i]!, points[i + 1]!, points[i + 2]!);
    }
    carriers.push(at);
  }
  return { places, carriers };
}
