import type { Vec3 } from '../../fields/types.js';

/** A place on a rope or on a surface: a mean of some of its points. */
export interface SoftPlace {
  readonly points: number[];
  readonly shares: number[];
  /** Of a surface there, a unit vector; of a rope there is none. */
  readonly normal: Vec3;
}

/** A line of sight, metres: where it begins and ends, and how far beside it what is meant may be, at either end. */
export interface SoftSight {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly beside: readonly [near: number, far: number];
}

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const clamped = (v: number): number => Math.min(1, Math.max(0, v)) || 0;
const pointOf = (places: Float64Array, i: number): Vec3 => [
  places[3 * i]!,
  places[3 * i + 1]!,
  places[3 * i + 2]!,
];

/** The nearest place to a point on links between such points, of which all others are left out. */
export function nearestOnLine(
  places: Float64Array,
  point: Vec3,
  free: (i: number) => boolean,
): SoftPlace | undefined {
  let least = Infinity;
  let found: SoftPlace | undefined;
  for (let i = 0; 3 * i + 3 < places.length; i++) {
    const a = pointOf(places, i);
    const way = minus(pointOf(places, i + 1), a);
    const to = minus(point, a);
    let share = clamped(dot(to, way) / dot(way, way));
    if (!free(i)) share = 1;
    if (!free(i + 1)) share = 0;
    if (!free(i) && !free(i + 1)) continue;
    const off = to.map((v, k) => v - share * way[k]!) as Vec3;
    const square = dot(off, off);
    if (!(square < least)) continue;
    least = square;
    found = { points: [i, i + 1], shares: [1 - share, share], normal: [0, 0, 0] };
  }
  return found;
}

/** The nearest place to a point in triangles; points that are held have no share of it. */
export function nearestOnSurface(
  places: Float64Array,
  triangles: Int32Array,
  point: Vec3,
  free: (i: number) => boolean,
): SoftPlace | undefined {
  let least = Infinity;
  let found: SoftPlace | undefined;
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    if (isFarther(places, triangles, n, point, least)) continue;
    const points = [triangles[n]!, triangles[n + 1]!, triangles[n + 2]!].filter(free);
    // Torn.
    if (points.length === 0 || triangles[n] === triangles[n + 1]) continue;
    const shares = nearestShares(
      points.map((i) => pointOf(places, i)),
      point,
    );
    const off: Vec3 = [...point];
    points.forEach((i, m) => {
      for (let k = 0; k < 3; k++) off[k]! -= shares[m]! * places[3 * i + k]!;
    });
    const square = dot(off, off);
    if (!(square < least)) continue;
    least = square;
    found = { points, shares, normal: normalOf(places, triangles, n) };
  }
  return found;
}

/** Whether all of a triangle is farther from a point than that: of most it is told by their first corner and their size. */
function isFarther(
  places: Float64Array,
  triangles: Int32Array,
  n: number,
  point: Vec3,
  square: number,
): boolean {
  const a = 3 * triangles[n]!;
  const b = 3 * triangles[n + 1]!;
  const c = 3 * triangles[n + 2]!;
  let off = 0;
  let one = 0;
  let other = 0;
  for (let k = 0; k < 3; k++) {
    const p = places[a + k]!;
    off += (point[k]! - p) ** 2;
    one += (places[b + k]! - p) ** 2;
    other += (places[c + k]! - p) ** 2;
  }
  return Math.sqrt(off) - Math.sqrt(Math.max(one, other)) > Math.sqrt(square);
}

function normalOf(places: Float64Array, triangles: Int32Array, n: number): Vec3 {
  const a = pointOf(places, triangles[n]!);
  const one = minus(pointOf(places, triangles[n + 1]!), a);
  const normal = cross(one, minus(pointOf(places, triangles[n + 2]!), a));
  const size = Math.sqrt(dot(normal, normal)) || 1;
  return [normal[0] / size, normal[1] / size, normal[2] / size];
}

/** Of a point, of a line or of a triangle. */
function nearestShares(corners: readonly Vec3[], point: Vec3): number[] {
  const [a, b, c] = corners as [Vec3, Vec3, Vec3];
  if (corners.length === 1) return [1];
  if (corners.length === 2) {
    const way = minus(b, a);
    const share = clamped(dot(minus(point, a), way) / dot(way, way));
    return [1 - share, share];
  }
  const normal = cross(minus(b, a), minus(c, a));
  const area = dot(normal, normal);
  const shareOf = (p: Vec3, q: Vec3): number =>
    dot(normal, cross(minus(q, p), minus(point, p))) / area;
  const inside = [shareOf(b, c), shareOf(c, a), shareOf(a, b)];
  if (area > 0 && inside.every((share) => share >= 0)) return inside;
  return nearestSide(corners, point);
}

function nearestSide(corners: readonly Vec3[], point: Vec3): number[] {
  let least = Infinity;
  let found = [1, 0, 0];
  for (let side = 0; side < 3; side++) {
    const [a, b] = [side, (side + 1) % 3] as const;
    const [one, other] = nearestShares([corners[a]!, corners[b]!], point) as [number, number];
    const off = [0, 1, 2].map(
      (k) => point[k]! - one * corners[a]![k]! - other * corners[b]![k]!,
    ) as Vec3;
    const square = dot(off, off);
    if (!(square < least)) continue;
    least = square;
    found = [0, 0, 0];
    found[a] = one;
    found[b] = other;
  }
  return found;
}

/** Which share of a line of sight lies before a rope that is so thick, metres; undefined: it passes by. */
export function sightOfLine(
  places: Float64Array,
  radius: number,
  { from, to, beside: [near, far] }: SoftSight,
): number | undefined {
  const way = minus(to, from);
  const along = dot(way, way);
  let first = Infinity;
  for (let i = 0; 3 * i + 3 < places.length; i++) {
    const a = pointOf(places, i);
    const link = minus(pointOf(places, i + 1), a);
    // Where two lines come nearest to each other.
    const start = minus(a, from);
    const both = dot(link, way);
    const own = dot(link, link);
    const det = own * along - both * both;
    const share = clamped((both * dot(start, way) - along * dot(start, link)) / det);
    const at = clamped((dot(start, way) + share * both) / along);
    const off = [0, 1, 2].map((k) => start[k]! + share * link[k]! - at * way[k]!) as Vec3;
    const reach = Math.max(radius, near + at * (far - near));
    if (dot(off, off) > reach * reach) continue;
    first = Math.min(first, at);
  }
  return first < Infinity ? Math.max(0, first - radius / Math.sqrt(along)) : undefined;
}

/** The same of triangles, seen from both sides. */
export function sightOfSurface(
  places: Float64Array,
  triangles: Int32Array,
  { from, to }: SoftSight,
): number | undefined {
  const way = minus(to, from);
  let first = Infinity;
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    const a = pointOf(places, triangles[n]!);
    const one = minus(pointOf(places, triangles[n + 1]!), a);
    const other = minus(pointOf(places, triangles[n + 2]!), a);
    // By Möller and Trumbore.
    const p = cross(way, other);
    const det = dot(one, p);
    if (det === 0) continue;
    const start = minus(from, a);
    const u = dot(start, p) / det;
    const q = cross(start, one);
    const v = dot(way, q) / det;
    const at = dot(other, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && at >= 0 && at <= 1) first = Math.min(first, at);
  }
  return first < Infinity ? first : undefined;
}
