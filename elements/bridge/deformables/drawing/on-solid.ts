import { normalsOf } from './groups.js';
import type { TextureOn } from './surface-data.js';

type Vector = readonly [number, number, number];
type Place = [number, number];

/** What is nearer to its axis than this share of its size is on it. */
const ON_AXIS = 1e-6;

/** How X3D lays a picture on a solid: of a point of a triangle that looks along an axis, or beside one. */
const SOLIDS: Record<string, (point: Vector, half: Vector, axis: number, sign: number) => Place> = {
  Box: ([x, y, z], half, axis, sign) => {
    const [sx, sy, sz] = half;
    if (axis === 0) return [share(-sign * z, sz), share(y, sy)];
    if (axis === 1) return [share(x, sx), share(-sign * z, sz)];
    return [share(sign * x, sx), share(y, sy)];
  },
  Sphere: ([x, y, z], [r]) => [
    around(x, z, r),
    0.5 + Math.asin(Math.max(-1, Math.min(1, y / r))) / Math.PI,
  ],
  Cylinder: turned,
  Cone: turned,
};

/** Its ends have it whole. */
function turned([x, y, z]: Vector, half: Vector, axis: number, sign: number): Place {
  if (axis === 1) return [share(x, half[0]), share(-sign * z, half[2])];
  return [around(x, z, half[0]), share(y, half[1])];
}

/** From one side to the other. */
const share = (value: number, half: number): number => (half > 0 ? (value / half + 1) / 2 : 0);

/** Once around from behind; NaN on the axis, where it is any way. */
const around = (x: number, z: number, size: number): number =>
  x * x + z * z > (ON_AXIS * size) ** 2 ? 0.5 + Math.atan2(x, z) / (2 * Math.PI) : NaN;

/** Of a solid in its own frame; undefined where it is none. */
export function onSolid(
  type: string,
  points: ArrayLike<number>,
  triangles: Int32Array,
): TextureOn | undefined {
  const solid = SOLIDS[type];
  if (!solid) return undefined;
  const half = [0, 1, 2].map((k) => reach(points, k)) as unknown as Vector;
  const normals = normalsOf(points, triangles);
  const known = new Map<string, number>();
  const places: number[] = [];
  const index = new Int32Array(triangles.length);
  for (let n = 0; n + 2 < triangles.length; n += 3) {
    const corners = [0, 1, 2].map((k) => vectorAt(points, triangles[n + k]!));
    const axis = type === 'Box' ? largest(vectorAt(normals, n / 3)) : endAxis(normals, n);
    const sign = Math.sign(corners[0]![axis] + corners[1]![axis] + corners[2]![axis]) || 1;
    const laid = corners.map((corner) => solid(corner, half, axis, sign));
    const three = type === 'Sphere' || (type !== 'Box' && axis === 0) ? whole(laid) : laid;
    three.forEach(([s, t], k) => {
      const key = `${s.toFixed(6)} ${t.toFixed(6)}`;
      let at = known.get(key);
      if (at === undefined) known.set(key, (at = places.push(s, t) / 2 - 1));
      index[n + k] = at;
    });
  }
  return { places, index };
}

/** Where a triangle lies over the seam its picture goes on; what is on the axis is in the middle of the others. */
function whole(three: Place[]): Place[] {
  const there = three.map(([s]) => s).filter((s) => !Number.isNaN(s));
  const most = Math.max(...there);
  const on = there.map((s) => (most - s > 0.5 ? s + 1 : s));
  const middle = on.reduce((sum, s) => sum + s, 0) / (on.length || 1);
  return three.map(([s, t]) => [Number.isNaN(s) ? middle : most - s > 0.5 ? s + 1 : s, t]);
}

const vectorAt = (list: ArrayLike<number>, i: number): Vector => [
  list[3 * i]!,
  list[3 * i + 1]!,
  list[3 * i + 2]!,
];

const largest = (v: Vector): number => {
  const [x, y, z] = v.map(Math.abs) as [number, number, number];
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
};

/** The ends of what is turned round its y axis are level. */
const endAxis = (normals: Float64Array, n: number): number =>
  Math.abs(normals[n + 1]!) > 1 - ON_AXIS ? 1 : 0;

/** How far it reaches from its middle. */
function reach(points: ArrayLike<number>, axis: number): number {
  let most = 0;
  for (let i = axis; i < points.length; i += 3) most = Math.max(most, Math.abs(points[i]!));
  return most;
}
