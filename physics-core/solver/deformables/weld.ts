// What surfaces are when they come: points that are laid twice, or nowhere.

/** Those whose corners are points that are somewhere. */
export function finiteTriangles(points: ArrayLike<number>, index: ArrayLike<number>): Int32Array {
  const count = Math.floor(points.length / 3);
  const finite = new Uint8Array(count);
  for (let i = 0; i < count; i++)
    if (Number.isFinite(points[3 * i]! + points[3 * i + 1]! + points[3 * i + 2]!)) finite[i] = 1;
  const triangles = new Int32Array(index.length);
  let length = 0;
  for (let t = 0; t + 2 < index.length; t += 3) {
    if (!finite[index[t]!] || !finite[index[t + 1]!] || !finite[index[t + 2]!]) continue;
    for (let c = 0; c < 3; c++) triangles[length++] = index[t + c]!;
  }
  return triangles.slice(0, length);
}

/** A triangle that is lower than this share of its longest side has no plane. */
const SLIVER = 1e-6;

export interface Skinned {
  /** Points that are corners, none of them twice: x, y, z of each. */
  readonly places: Float64Array;
  readonly triangles: Int32Array;
  /** Of each point as it came, the one that it is the same as, or that is nearest. */
  readonly carriers: Int32Array;
}

/** The same surface, without points that are laid twice or nowhere, and without triangles that have no area. */
export function skinOf(points: ArrayLike<number>, triangles: Int32Array): Skinned {
  const { numbers, places } = weld(points);
  const used = new Int32Array(places.length / 3).fill(-1);
  const kept: number[] = [];
  const corners: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    if (!hasPlane(places, numbers[triangles[t]!]!, numbers[triangles[t + 1]!]!, numbers[triangles[t + 2]!]!)) continue; // prettier-ignore
    for (let c = 0; c < 3; c++) {
      const number = numbers[triangles[t + c]!]!;
      if (used[number]! < 0) {
        used[number] = kept.length / 3;
        for (let k = 0; k < 3; k++) kept.push(places[3 * number + k]!);
      }
      corners.push(used[number]!);
    }
  }
  if (corners.length === 0)
    return { places: new Float64Array(0), triangles: new Int32Array(0), carriers: new Int32Array(0) }; // prettier-ignore
  // What belongs to no triangle is not drawn, whatever carries it; what belongs to one without area is.
  for (const i of triangles) {
    const number = numbers[i]!;
    if (used[number]! < 0) used[number] = nearest(kept, places, number);
  }
  const carriers = numbers.map((number) => (number < 0 ? 0 : Math.max(0, used[number]!)));
  return { places: Float64Array.from(kept), triangles: Int32Array.from(corners), carriers };
}

function hasPlane(places: Float64Array, o: number, p: number, q: number): boolean {
  const longest = Math.max(apart(places, o, places, p), apart(places, p, places, q), apart(places, q, places, o)); // prettier-ignore
  let twice = 0;
  for (let k = 0; k < 3; k++) {
    const l = (k + 1) % 3;
    const m = (k + 2) % 3;
    const side = (c: number, along: number): number =>
      places[3 * c + along]! - places[3 * o + along]!;
    const area = side(p, l) * side(q, m) - side(p, m) * side(q, l);
    twice += area * area;
  }
  return Math.sqrt(twice) > SLIVER * longest;
}

/** The square of how far points are apart. */
function apart(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): number {
  let square = 0;
  for (let k = 0; k < 3; k++) {
    const way = a[3 * i + k]! - b[3 * j + k]!;
    square += way * way;
  }
  return square;
}

function nearest(kept: readonly number[], places: Float64Array, number: number): number {
  let best = 0;
  let least = Infinity;
  for (let n = 0; 3 * n < kept.length; n++) {
    const square = apart(kept, n, places, number);
    if (square < least) {
      least = square;
      best = n;
    }
  }
  return best;
}

/** Which points are one: closer than this share of their box. Seams of what is turned are off by rounding. */
const SAME = 1e-6;

/** Of each point the number of the one that it is the same as, and where those are; -1: it is nowhere. */
export function weld(points: ArrayLike<number>): { numbers: Int32Array; places: Float64Array } {
  const count = Math.floor(points.length / 3);
  const numbers = new Int32Array(count).fill(-1);
  const near = SAME * extent(points);
  const places = new Places(near);
  for (let i = 0; i < count; i++) {
    const x = points[3 * i]!;
    const y = points[3 * i + 1]!;
    const z = points[3 * i + 2]!;
    if (Number.isFinite(x + y + z)) numbers[i] = places.numberOf(x, y, z);
  }
  return { numbers, places: Float64Array.from(places.all) };
}

function extent(points: ArrayLike<number>): number {
  let most = 0;
  for (let k = 0; k < 3; k++) {
    let low = Infinity;
    let high = -Infinity;
    for (let j = k; j < points.length; j += 3) {
      const p = points[j]!;
      if (!Number.isFinite(p)) continue;
      low = Math.min(low, p);
      high = Math.max(high, p);
    }
    if (high > low) most = Math.max(most, high - low);
  }
  return most;
}

/** Points in boxes that are wide enough for nearly all of them to lie in one alone, with all that are the same. */
class Places {
  readonly all: number[] = [];
  private readonly near: number;
  private readonly wide: number;
  private readonly boxes = new Map<string, number[]>();

  constructor(near: number) {
    this.near = near;
    this.wide = 1000 * near || 1;
  }

  numberOf(x: number, y: number, z: number): number {
    const { all, near } = this;
    const found = this.look(x, y, z);
    if (found >= 0) return found;
    const number = all.length / 3;
    all.push(x, y, z);
    for (const i of this.spread(x, near))
      for (const j of this.spread(y, near))
        for (const k of this.spread(z, near)) {
          const key = `${i} ${j} ${k}`;
          const box = this.boxes.get(key);
          if (box) box.push(number);
          else this.boxes.set(key, [number]);
        }
    return number;
  }

  private look(x: number, y: number, z: number): number {
    const { all, near } = this;
    const key = [x, y, z].map((p) => Math.floor(p / this.wide)).join(' ');
    for (const n of this.boxes.get(key) ?? [])
      if (
        Math.abs(all[3 * n]! - x) <= near &&
        Math.abs(all[3 * n + 1]! - y) <= near &&
        Math.abs(all[3 * n + 2]! - z) <= near
      )
        return n;
    return -1;
  }

  /** The boxes along one axis from which a point is near. */
  private spread(p: number, near: number): number[] {
    const first = Math.floor((p - near) / this.wide);
    const last = Math.floor((p + near) / this.wide);
    return first === last ? [first] : [first, last];
  }
}
