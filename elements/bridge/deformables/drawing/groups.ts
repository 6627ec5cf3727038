/** What meets at a sharper angle than this as it is laid has an edge there: the cosine of 60°. */
const EDGE = 0.5;

/** What is as near as this share of all is in one place, as the core has it. */
const NEAR = 1e-6;

/**
 * Corners of triangles that are one round: those in one place whose triangles, as the surface is laid, go over into each other.
 * Answers which group each corner is of; -1: its triangle has two corners in one place, and is not to be seen.
 */
export function groupsOf(
  laid: ArrayLike<number>,
  triangles: Int32Array,
): { groups: Int32Array; count: number } {
  const { placeOf, count } = placesOf(laid);
  const groups = Int32Array.from(triangles, (point) => placeOf[point]!);
  const around: number[][] = Array.from({ length: count }, () => []);
  for (let n = 0; n + 2 < groups.length; n += 3) {
    const [a, b, c] = groups.subarray(n, n + 3) as unknown as [number, number, number];
    if (a === b || b === c || c === a) groups.fill(-1, n, n + 3);
    else [a, b, c].forEach((place, k) => around[place]!.push(n + k));
  }
  const normals = normalsOf(laid, triangles);
  let next = 0;
  for (const corners of around)
    while (corners.length > 0) next = takeRound(corners, normals, groups, next);
  return { groups, count: next };
}

/** Which points are in one place. */
function placesOf(laid: ArrayLike<number>): { placeOf: Int32Array; count: number } {
  const known = new Map<string, number>();
  let size = 0;
  const off = (i: number): number => laid[i]! - laid[i % 3]!;
  for (let i = 0; i < laid.length; i++) size = Math.max(size, Math.abs(off(i)));
  // The points of a Sphere's pole are beside each other by the rounding of a sine.
  const at = (i: number): number => Math.round(off(i) / (NEAR * size || 1)) + 0;
  const placeOf = new Int32Array(laid.length / 3);
  for (let i = 0; i < placeOf.length; i++) {
    const key = `${at(3 * i)} ${at(3 * i + 1)} ${at(3 * i + 2)}`;
    const place = known.get(key) ?? known.size;
    known.set(key, place);
    placeOf[i] = place;
  }
  return { placeOf, count: known.size };
}

/** Takes the first of some corners out, with all to which there is a round way from it. */
function takeRound(
  corners: number[],
  normals: Float64Array,
  groups: Int32Array,
  group: number,
): number {
  const found = [corners.pop()!];
  for (const from of found) {
    groups[from] = group;
    for (let i = corners.length - 1; i >= 0; i--)
      if (along(normals, from, corners[i]!) >= EDGE) found.push(...corners.splice(i, 1));
  }
  return group + 1;
}

/** The cosine between the triangles of two corners. */
function along(normals: Float64Array, one: number, other: number): number {
  const a = 3 * Math.floor(one / 3);
  const b = 3 * Math.floor(other / 3);
  return (
    normals[a]! * normals[b]! +
    normals[a + 1]! * normals[b + 1]! +
    normals[a + 2]! * normals[b + 2]!
  );
}

/** Of each triangle as it is laid. */
export function normalsOf(p: ArrayLike<number>, triangles: Int32Array): Float64Array {
  const out = new Float64Array(triangles.length);
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[n + k]!) as [number, number, number];
    const u = [0, 1, 2].map((k) => p[b + k]! - p[a + k]!) as [number, number, number];
    const v = [0, 1, 2].map((k) => p[c + k]! - p[a + k]!) as [number, number, number];
    const x = u[1] * v[2] - u[2] * v[1];
    const y = u[2] * v[0] - u[0] * v[2];
    const z = u[0] * v[1] - u[1] * v[0];
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0) out.set([x / length, y / length, z / length], n);
  }
  return out;
}
