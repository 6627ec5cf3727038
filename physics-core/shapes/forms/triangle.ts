import { hypot } from '../../base/exact/index.js';
import type { Flat, Form } from './form.js';

/** A triangle with two sides. One object goes from triangle to triangle of a surface. */
export class TriangleForm implements Form {
  readonly round = 0;
  readonly cornered = true;
  readonly corners = new Float64Array(9);
  readonly normal = new Float64Array(3);

  set(points: Flat, index: Int32Array, normals: Flat, triangle: number): void {
    for (let i = 0; i < 3; i++) {
      const at = 3 * index[3 * triangle + i]!;
      for (let k = 0; k < 3; k++) this.corners[3 * i + k] = points[at + k]!;
      this.normal[i] = normals[3 * triangle + i]!;
    }
  }

  /** Few of those that it becomes are asked for that. */
  get reach(): number {
    const { corners } = this;
    let reach = 0;
    for (let i = 3; i < 9; i += 3)
      reach = Math.max(
        reach,
        hypot(
          corners[i]! - corners[0]!,
          corners[i + 1]! - corners[1]!,
          corners[i + 2]! - corners[2]!,
        ),
      );
    return reach;
  }

  /** Whether it has no area, and so no normal. */
  get isFlat(): boolean {
    return this.normal[0] === 0 && this.normal[1] === 0 && this.normal[2] === 0;
  }

  #along(corner: number, x: number, y: number, z: number): number {
    const { corners } = this;
    return corners[3 * corner]! * x + corners[3 * corner + 1]! * y + corners[3 * corner + 2]! * z;
  }

  #farthest(x: number, y: number, z: number): number {
    const a = this.#along(0, x, y, z);
    const b = this.#along(1, x, y, z);
    const c = this.#along(2, x, y, z);
    if (a >= b && a >= c) return 0;
    return b >= c ? 1 : 2;
  }

  #copy(corner: number, out: Flat, at: number): void {
    for (let k = 0; k < 3; k++) out[at + k] = this.corners[3 * corner + k]!;
  }

  support(direction: Flat, out: Flat): void {
    this.#copy(this.#farthest(direction[0]!, direction[1]!, direction[2]!), out, 0);
  }

  facing(x: number, y: number, z: number, out: Flat): number {
    const { normal } = this;
    const front = normal[0]! * x + normal[1]! * y + normal[2]! * z >= 0;
    for (let k = 0; k < 3; k++) out[k] = front ? normal[k]! : -normal[k]!;
    return front ? 0 : 1;
  }

  face(number: number, out: Flat): number {
    for (let i = 0; i < 3; i++) this.#copy(number === 0 ? i : 2 - i, out, 3 * i);
    return 3;
  }

  lying(x: number, y: number, z: number, _u: number, _v: number, _w: number, out: Flat): number {
    const { normal } = this;
    return this.face(normal[0]! * x + normal[1]! * y + normal[2]! * z >= 0 ? 0 : 1, out);
  }

  /** Of the two sides at the farthest corner the one that lies more along the plane. */
  line(x: number, y: number, z: number, out: Flat): number {
    const corner = this.#farthest(x, y, z);
    this.#copy(corner, out, 0);
    let least = ALONG;
    let found = -1;
    for (let i = 1; i < 3; i++) {
      const next = (corner + i) % 3;
      this.#copy(next, out, 3);
      const u = out[3]! - out[0]!;
      const v = out[4]! - out[1]!;
      const w = out[5]! - out[2]!;
      const sine = Math.abs(x * u + y * v + z * w) / hypot(u, v, w);
      if (sine < least) {
        least = sine;
        found = next;
      }
    }
    if (found < 0) return 1;
    this.#copy(found, out, 3);
    return 2;
  }
}

/** Within this angle from it, in radians, a side lies along a plane. */
const ALONG = 0.02;
