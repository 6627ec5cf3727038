/** Whether the triangles of a closed surface face outward: what it encloses is more than nothing. */
export function isOutward(p: ArrayLike<number>, triangles: Int32Array): boolean {
  let volume = 0;
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[n + k]!) as [number, number, number];
    volume +=
      p[a]! * (p[b + 1]! * p[c + 2]! - p[b + 2]! * p[c + 1]!) +
      p[a + 1]! * (p[b + 2]! * p[c]! - p[b]! * p[c + 2]!) +
      p[a + 2]! * (p[b]! * p[c + 1]! - p[b + 1]! * p[c]!);
  }
  return volume > 0;
}
