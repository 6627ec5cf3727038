import { grown, grownInt } from '../../base/grown.js';
import { MOST_BOXES } from '../tolerances.js';
import type { Masses } from './masses.js';

/** Of a triangle: what share each corner has of its point that is nearest. */
const shares = new Float64Array(3);
const way = new Float64Array(3);

/**
 * A surface that does not go through itself: its points stay as far from its triangles as it is thick, or as they were laid.
 * Who may come near whom in a step is looked up in boxes of space; on which side a point is when the step begins it stays.
 */
export class Apart {
  readonly #triangles: ArrayLike<number>;
  readonly #laid: Float64Array;
  /** The longest edge, metres. */
  readonly #edge: number;
  #boxes = new Map<number, number[]>();
  count = 0;
  /** The point, and the corners of the triangle. */
  #points = new Int32Array(0);
  #shares = new Float64Array(0);
  #normals = new Float64Array(0);
  #gaps = new Float64Array(0);

  constructor(places: ArrayLike<number>, triangles: ArrayLike<number>) {
    this.#laid = Float64Array.from(places);
    this.#triangles = triangles;
    let most = 0;
    for (let n = 0; n < triangles.length; n++) {
      const next = n % 3 === 2 ? n - 2 : n + 1;
      let square = 0;
      for (let k = 0; k < 3; k++)
        square += (places[3 * triangles[n]! + k]! - places[3 * triangles[next]! + k]!) ** 2;
      most = Math.max(most, square);
    }
    this.#edge = Math.sqrt(most);
  }

  /** Who is near whom when a step begins: nearer than `thickness`, and what points go in it. */
  look(
    { places, velocities, count }: Masses,
    thickness: number,
    dt: number,
    gone: Uint8Array,
  ): void {
    this.count = 0;
    let fastest = 0;
    for (let j = 0; j < 3 * count; j++) fastest = Math.max(fastest, Math.abs(velocities[j]!));
    const reach = thickness + Math.min(2 * dt * fastest, this.#edge / 2);
    const size = Math.max(this.#edge, reach);
    this.#fill(places, size, reach, gone);
    for (let i = 0; i < count; i++) {
      const near = this.#boxes.get(keyOf(places, 3 * i, size));
      if (near) for (const f of near) this.#meet(places, i, f, thickness, reach);
    }
  }

  #fill(places: Float64Array, size: number, reach: number, gone: Uint8Array): void {
    this.#boxes = new Map();
    const triangles = this.#triangles;
    const low = [0, 0, 0];
    const high = [0, 0, 0];
    for (let f = 0; 3 * f + 2 < triangles.length; f++) {
      if (gone[f] === 1) continue;
      for (let k = 0; k < 3; k++) {
        const [a, b, c] = [0, 1, 2].map((n) => places[3 * triangles[3 * f + n]! + k]!) as Three;
        low[k] = Math.floor((Math.min(a, b, c) - reach) / size);
        high[k] = Math.floor((Math.max(a, b, c) + reach) / size);
        // What is stretched beyond all bounds, or is nowhere, meets nothing.
        if (!(high[k]! - low[k]! < MOST_BOXES)) high[k] = low[k]! - 1;
      }
      for (let x = low[0]!; x <= high[0]!; x++)
        for (let y = low[1]!; y <= high[1]!; y++)
          for (let z = low[2]!; z <= high[2]!; z++) {
            const key = keyAt(x, y, z);
            const known = this.#boxes.get(key);
            if (known) known.push(f);
            else this.#boxes.set(key, [f]);
          }
    }
  }

  #meet(places: Float64Array, i: number, f: number, thickness: number, reach: number): void {
    const triangles = this.#triangles;
    const a = triangles[3 * f]!;
    const b = triangles[3 * f + 1]!;
    const c = triangles[3 * f + 2]!;
    if (i === a || i === b || i === c) return;
    nearest(places, i, a, b, c);
    const now = awayFrom(places, i, a, b, c);
    if (!(now < reach) || !(now > 0)) return;
    const n = this.count++;
    this.#grow();
    for (let k = 0; k < 3; k++) {
      this.#normals[3 * n + k] = way[k]! / now;
      this.#shares[3 * n + k] = shares[k]!;
    }
    this.#points.set([i, a, b, c], 4 * n);
    this.#gaps[n] = Math.min(thickness, awayFrom(this.#laid, i, a, b, c));
  }

  #grow(): void {
    if (this.count <= this.#gaps.length) return;
    const room = 2 * this.count + 16;
    this.#points = grownInt(this.#points, 4 * room);
    this.#shares = grown(this.#shares, 3 * room);
    this.#normals = grown(this.#normals, 3 * room);
    this.#gaps = grown(this.#gaps, room);
  }

  /** Who is too near goes away, each by what it weighs; what went along one another is held by friction. */
  hold({ places, before, inverse }: Masses, friction: number): void {
    const all = this.#points;
    for (let n = 0; n < this.count; n++) {
      const i = all[4 * n]!;
      let gap = -this.#gaps[n]!;
      let gives = inverse[i]!;
      let square = 0;
      for (let m = 0; m < 3; m++)
        gives += this.#shares[3 * n + m]! ** 2 * inverse[all[4 * n + 1 + m]!]!;
      for (let k = 0; k < 3; k++) {
        let off = places[3 * i + k]!;
        let was = before[3 * i + k]!;
        for (let m = 0; m < 3; m++) {
          const j = 3 * all[4 * n + 1 + m]! + k;
          off -= this.#shares[3 * n + m]! * places[j]!;
          was -= this.#shares[3 * n + m]! * before[j]!;
        }
        gap += this.#normals[3 * n + k]! * off;
        way[k] = off - was;
      }
      if (!(gap < 0) || !(gives > 0)) continue;
      const press = -gap / gives;
      let out = 0;
      for (let k = 0; k < 3; k++) out += way[k]! * this.#normals[3 * n + k]!;
      for (let k = 0; k < 3; k++) {
        way[k]! -= out * this.#normals[3 * n + k]!;
        square += way[k]! * way[k]!;
      }
      const far = Math.sqrt(square);
      const rub = far > 0 ? Math.min(friction * press, far / gives) / far : 0;
      for (let k = 0; k < 3; k++) {
        const push = press * this.#normals[3 * n + k]! - rub * way[k]!;
        places[3 * i + k]! += inverse[i]! * push;
        for (let m = 0; m < 3; m++) {
          const j = all[4 * n + 1 + m]!;
          places[3 * j + k]! -= this.#shares[3 * n + m]! * inverse[j]! * push;
        }
      }
    }
  }
}

type Three = [number, number, number];

/** Numbers of boxes: two in one are only looked at in vain. */
const keyAt = (x: number, y: number, z: number): number =>
  (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) | 0;

const keyOf = (places: Float64Array, at: number, size: number): number =>
  keyAt(
    Math.floor(places[at]! / size),
    Math.floor(places[at + 1]! / size),
    Math.floor(places[at + 2]! / size),
  );

/** How far a point is from that of a triangle which `shares` say; the way there from it to `way`. */
function awayFrom(places: Float64Array, i: number, a: number, b: number, c: number): number {
  let square = 0;
  for (let k = 0; k < 3; k++) {
    way[k] =
      places[3 * i + k]! -
      shares[0]! * places[3 * a + k]! -
      shares[1]! * places[3 * b + k]! -
      shares[2]! * places[3 * c + k]!;
    square += way[k]! * way[k]!;
  }
  return Math.sqrt(square);
}

/** The point of a triangle that is nearest to another one (Ericson, Real-Time Collision Detection, 5.1.5). */
function nearest(p: Float64Array, i: number, a: number, b: number, c: number): void {
  const dot = (o: number, u: number, q: number, v: number): number => {
    let sum = 0;
    for (let k = 0; k < 3; k++)
      sum += (p[3 * u + k]! - p[3 * o + k]!) * (p[3 * v + k]! - p[3 * q + k]!);
    return sum;
  };
  const d1 = dot(a, b, a, i);
  const d2 = dot(a, c, a, i);
  if (d1 <= 0 && d2 <= 0) return set(1, 0, 0);
  const d3 = dot(a, b, b, i);
  const d4 = dot(a, c, b, i);
  if (d3 >= 0 && d4 <= d3) return set(0, 1, 0);
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return set(1 - d1 / (d1 - d3), d1 / (d1 - d3), 0);
  const d5 = dot(a, b, c, i);
  const d6 = dot(a, c, c, i);
  if (d6 >= 0 && d5 <= d6) return set(0, 0, 1);
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return set(1 - d2 / (d2 - d6), 0, d2 / (d2 - d6));
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const share = (d4 - d3) / (d4 - d3 + d5 - d6);
    return set(0, 1 - share, share);
  }
  const all = va + vb + vc;
  return all > 0 ? set(va / all, vb / all, vc / all) : set(1, 0, 0);
}

function set(a: number, b: number, c: number): void {
  shares[0] = a;
  shares[1] = b;
  shares[2] = c;
}
