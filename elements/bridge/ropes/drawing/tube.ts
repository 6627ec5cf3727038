import { indexOf } from '../../matter/index-of.js';
import type { Form } from './form.js';

/** Corners around it; each ring has the first one twice, where its texture begins and ends. */
const SIDES = 8;
const RING = SIDES + 1;
/** Below this a way is none: a share of the radius, and of one. */
const NONE = 1e-9;

const COSINES = Array.from({ length: RING }, (_, i) => Math.cos((2 * Math.PI * i) / SIDES));
const SINES = Array.from({ length: RING }, (_, i) => Math.sin((2 * Math.PI * i) / SIDES));

type Vector = [number, number, number];

/** A rope as a tube with closed ends: a ring of corners around each of its points, and one more for each end. */
export class Tube implements Form {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly texCoords: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  readonly reach: number;
  readonly #count: number;
  /** Along the rope where the ring is. */
  readonly #along: Vector = [0, 0, 0];
  /** Across it, where a ring begins: carried from ring to ring without a twist, and at the first from frame to frame. */
  readonly #across: Vector = [0, 0, 0];
  readonly #first: Vector = [0, 1, 0];
  readonly #beside: Vector = [0, 0, 0];

  constructor(count: number, radius: number) {
    this.#count = count;
    this.reach = radius;
    const corners = (count + 2) * RING;
    this.positions = new Float32Array(3 * corners);
    this.normals = new Float32Array(3 * corners);
    this.texCoords = this.#spreadTexture(corners);
    this.index = this.#indexOf(corners);
  }

  /** Once around, and along it from its first point to its last, which the ends have over their disks. */
  #spreadTexture(corners: number): Float32Array {
    const out = new Float32Array(2 * corners);
    for (let ring = 0; ring < this.#count + 2; ring++)
      for (let i = 0; i < RING; i++) {
        const isEnd = ring >= this.#count;
        const at = 2 * (ring * RING + i);
        out[at] = isEnd ? (1 + COSINES[i]!) / 2 : i / SIDES;
        out[at + 1] = isEnd ? (1 + SINES[i]!) / 2 : ring / (this.#count - 1);
      }
    return out;
  }

  #indexOf(corners: number): Uint16Array | Uint32Array {
    const all: number[] = [];
    for (let ring = 0; ring < this.#count - 1; ring++)
      for (let i = 0; i < SIDES; i++) {
        const a = ring * RING + i;
        const b = a + RING;
        all.push(a, a + 1, b + 1, a, b + 1, b);
      }
    for (let i = 1; i < SIDES - 1; i++) {
      const start = this.#count * RING;
      const end = start + RING;
      all.push(start, start + i + 1, start + i, end, end + i, end + i + 1);
    }
    return indexOf(all, corners);
  }

  write(points: Float64Array): void {
    const last = this.#count - 1;
    for (let k = 0; k < 3; k++) this.#across[k] = this.#first[k]!;
    for (let ring = 0; ring <= last; ring++) {
      this.#turn(points, ring);
      if (ring === 0) for (let k = 0; k < 3; k++) this.#first[k] = this.#across[k]!;
      this.#writeRing(points, ring);
      if (ring === 0) this.#writeEnd(0, last + 1, -1);
    }
    this.#writeEnd(last, last + 2, 1);
  }

  /** Along: in the middle between the ways to its neighbours. Across: what it was at the ring before, as far as that is. */
  #turn(points: Float64Array, ring: number): void {
    const along = this.#along;
    const at = 3 * ring;
    const [x, y, z] = along;
    along.fill(0);
    if (ring > 0) add(along, points, at - 3);
    if (ring < this.#count - 1) add(along, points, at);
    if (!normalize(along)) {
      // It turns back on itself there, or its points are in one place.
      if (ring === 0) along.splice(0, 3, 1, 0, 0);
      else along.splice(0, 3, x, y, z);
    }
    const across = this.#across;
    level(across, along);
    if (!normalize(across)) {
      // Any way that is not along it, from the axis that is the least so.
      const [a, b, c] = along.map(Math.abs) as Vector;
      across.fill(0);
      across[a <= b && a <= c ? 0 : b <= c ? 1 : 2] = 1;
      level(across, along);
      normalize(across);
    }
    const beside = this.#beside;
    beside[0] = along[1] * across[2] - along[2] * across[1];
    beside[1] = along[2] * across[0] - along[0] * across[2];
    beside[2] = along[0] * across[1] - along[1] * across[0];
  }

  #writeRing(points: Float64Array, ring: number): void {
    const { positions, normals } = this;
    const [across, beside] = [this.#across, this.#beside];
    for (let i = 0, to = 3 * ring * RING; i < RING; i++)
      for (let k = 0; k < 3; k++, to++) {
        const normal = COSINES[i]! * across[k]! + SINES[i]! * beside[k]!;
        normals[to] = normal;
        positions[to] = points[3 * ring + k]! + this.reach * normal;
      }
  }

  /** The corners of a ring once more, for the disk that closes it. */
  #writeEnd(ring: number, end: number, sign: number): void {
    const from = 3 * RING * ring;
    const to = 3 * RING * end;
    this.positions.copyWithin(to, from, from + 3 * RING);
    for (let i = 0; i < 3 * RING; i++) this.normals[to + i] = sign * this.#along[i % 3]!;
  }
}

/** The way from a point to the next, of length 1. */
function add(to: Vector, points: Float64Array, at: number): void {
  const x = points[at + 3]! - points[at]!;
  const y = points[at + 4]! - points[at + 1]!;
  const z = points[at + 5]! - points[at + 2]!;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return;
  to[0] += x / length;
  to[1] += y / length;
  to[2] += z / length;
}

/** Takes away what of it goes along. */
function level(across: Vector, along: Vector): void {
  const share = across[0] * along[0] + across[1] * along[1] + across[2] * along[2];
  for (let k = 0; k < 3; k++) across[k]! -= share * along[k]!;
}

function normalize(vector: Vector): boolean {
  const length = Math.sqrt(vector[0] ** 2 + vector[1] ** 2 + vector[2] ** 2);
  if (!(length > NONE)) return false;
  for (let k = 0; k < 3; k++) vector[k]! /= length;
  return true;
}
