import { indexOf } from '../../matter/index-of.js';
import { groupsOf } from './groups.js';
import type { TextureOn } from './surface-data.js';

/** What the mesh of a surface consists of; written anew in each frame in which it moved. */
export class Skin {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly texCoords: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  readonly #triangles: Int32Array;
  /** Of each corner of a triangle: with which others it is one round; -1: it is not to be seen. */
  readonly #rounds: Int32Array;
  /** The same of each corner of the mesh, and which point of the surface it is. */
  readonly #roundOf: Int32Array;
  readonly #pointOf: Int32Array;
  readonly #sums: Float64Array;

  /** `laid`: its points as it is laid, which say what belongs together. */
  constructor(laid: ArrayLike<number>, triangles: Int32Array, on: TextureOn) {
    const { groups, count } = groupsOf(laid, triangles);
    this.#triangles = triangles;
    this.#rounds = groups;
    this.#sums = new Float64Array(3 * count);
    const known = new Map<number, number>();
    const corners: number[] = [];
    const index: number[] = [];
    const points = laid.length / 3;
    const places = Math.max(1, on.places.length / 2);
    for (let n = 0; n < triangles.length; n++) {
      if (groups[n]! < 0) continue;
      const key = (groups[n]! * points + triangles[n]!) * places + on.index[n]!;
      let at = known.get(key);
      if (at === undefined) known.set(key, (at = corners.push(n) - 1));
      index.push(at);
    }
    this.#roundOf = Int32Array.from(corners, (n) => groups[n]!);
    this.#pointOf = Int32Array.from(corners, (n) => triangles[n]!);
    this.texCoords = new Float32Array(2 * corners.length);
    corners.forEach((n, at) => {
      for (let k = 0; k < 2; k++) this.texCoords[2 * at + k] = on.places[2 * on.index[n]! + k] ?? 0;
    });
    this.index = indexOf(index, corners.length);
    this.positions = new Float32Array(3 * corners.length);
    this.normals = new Float32Array(3 * corners.length);
  }

  /** Points of the surface: x, y, z of each, in what x3dom draws. */
  write(points: Float64Array): void {
    this.#sum(points);
    const { positions, normals } = this;
    const sums = this.#sums;
    for (let at = 0; at < this.#pointOf.length; at++)
      for (let k = 0; k < 3; k++) {
        positions[3 * at + k] = points[3 * this.#pointOf[at]! + k]!;
        normals[3 * at + k] = sums[3 * this.#roundOf[at]! + k]!;
      }
  }

  /** Each triangle turns what is round with it its way, by its area. */
  #sum(p: Float64Array): void {
    const sums = this.#sums.fill(0);
    const rounds = this.#rounds;
    const triangles = this.#triangles;
    for (let n = 0; n + 2 < triangles.length; n += 3) {
      if (rounds[n]! < 0) continue;
      const a = 3 * triangles[n]!;
      const b = 3 * triangles[n + 1]!;
      const c = 3 * triangles[n + 2]!;
      const ux = p[b]! - p[a]!;
      const uy = p[b + 1]! - p[a + 1]!;
      const uz = p[b + 2]! - p[a + 2]!;
      const vx = p[c]! - p[a]!;
      const vy = p[c + 1]! - p[a + 1]!;
      const vz = p[c + 2]! - p[a + 2]!;
      for (let k = 0; k < 3; k++) {
        const at = 3 * rounds[n + k]!;
        sums[at]! += uy * vz - uz * vy;
        sums[at + 1]! += uz * vx - ux * vz;
        sums[at + 2]! += ux * vy - uy * vx;
      }
    }
    for (let at = 0; at < sums.length; at += 3) {
      const x = sums[at]!;
      const y = sums[at + 1]!;
      const z = sums[at + 2]!;
      const length = Math.sqrt(x * x + y * y + z * z);
      const by = length > 0 ? 1 / length : 0;
      sums[at] = x * by;
      sums[at + 1] = y * by;
      sums[at + 2] = length > 0 ? z * by : 1;
    }
  }
}
