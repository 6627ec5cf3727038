/**
 * Points on a surface of triangles between those that it has, nowhere farther apart than `apart` metres: flat, without those
 * of the triangles themselves. No more than `most`.
 */
export function between(
  points: ArrayLike<number>,
  index: ArrayLike<number>,
  apart: number,
  most: number,
): number[] {
  const out: number[] = [];
  const known = new Set<string>();
  for (let f = 0; f + 2 < index.length; f += 3) {
    const face = [index[f]!, index[f + 1]!, index[f + 2]!];
    const order = Math.ceil(longest(points, face) / apart);
    if (!(order > 1) || !(order < most)) continue;
    for (let a = 0; a <= order; a++)
      for (let b = 0; a + b <= order; b++) {
        const shares = [a, b, order - a - b];
        const used = shares.filter((share) => share > 0).length;
        if (used < 2 || out.length >= 3 * most) continue;
        const place = [0, 1, 2].map((k) =>
          face.reduce((sum, point, n) => sum + (shares[n]! * points[3 * point + k]!) / order, 0),
        );
        const key = place.map((x) => Math.round((1000 * x) / apart)).join(' ');
        if (used === 2 && known.has(key)) continue;
        known.add(key);
        out.push(...place);
      }
  }
  return out;
}

export function longest(places: ArrayLike<number>, face: readonly number[]): number {
  let most = 0;
  for (let n = 0; n < 3; n++) {
    let square = 0;
    for (let k = 0; k < 3; k++)
      square += (places[3 * face[n]! + k]! - places[3 * face[(n + 1) % 3]! + k]!) ** 2;
    most = Math.max(most, square);
  }
  return Math.sqrt(most);
}
