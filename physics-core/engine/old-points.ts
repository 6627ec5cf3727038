import { PointerNumbers } from '../base/pointer-numbers.js';
import type { Ammo } from './ammo.js';
import { MANIFOLD, MANIFOLD_POINT as POINT, MOST_POINTS } from './offsets.js';

/** What is carried on from step to step: the last words of a point, its impulses first. */
const CARRIED = POINT.impulse / 4;
const WORDS = POINT.size / 4 - CARRIED;

/** Words that are kept of a point, and of a manifold's four: where it lies on B, its normal, and what is carried on. */
const NORMAL = 3;
const KEPT = 6;
const SIZE = KEPT + WORDS;
const BLOCK = SIZE * MOST_POINTS;

/** A normal that has turned farther, by its cosine, is of another contact. */
const SAME_SIDE = 0.7;

/**
 * The points of manifolds as the last step left them, with the impulses that its solver found: Bullet's search drops some of
 * them. What is found anew takes over the impulses of the nearest.
 */
export class OldPoints {
  readonly #ammo: Ammo;
  /** The block of points of each manifold. */
  readonly #blocks = new PointerNumbers();
  #words = new Int32Array(16 * BLOCK);
  #floats = new Float32Array(this.#words.buffer);
  /** Of each block: how many points, and of whom. */
  #counts: number[] = [];
  #a: number[] = [];
  #b: number[] = [];
  /** The block that is looked at, and which of its points were taken over, bit by bit. */
  #block = -1;
  #taken = 0;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  clear(): void {
    this.#blocks.clear();
  }

  keep(manifold: number, a: number, b: number): void {
    const block = this.#blocks.numberOf(manifold);
    if ((block + 1) * BLOCK > this.#words.length) this.#grow();
    const { HEAP32 } = this.#ammo;
    const count = HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
    const words = this.#words;
    for (let i = 0; i < count; i++) {
      const from = (manifold + MANIFOLD.points + i * POINT.size) >> 2;
      const to = block * BLOCK + i * SIZE;
      for (let k = 0; k < 3; k++) {
        words[to + k] = HEAP32[from + POINT.positionB / 4 + k]!;
        words[to + NORMAL + k] = HEAP32[from + POINT.normalB / 4 + k]!;
      }
      for (let k = 0; k < WORDS; k++) words[to + KEPT + k] = HEAP32[from + CARRIED + k]!;
    }
    this.#counts[block] = count;
    this.#a[block] = a;
    this.#b[block] = b;
  }

  #grow(): void {
    const words = new Int32Array(2 * this.#words.length);
    words.set(this.#words);
    this.#words = words;
    this.#floats = new Float32Array(words.buffer);
  }

  /** Those of this manifold are asked for from now on; where it was not kept (false), they are what stands in it. */
  look(manifold: number, a: number, b: number): boolean {
    const block = this.#blocks.find(manifold);
    const kept = block >= 0 && this.#a[block] === a && this.#b[block] === b;
    if (!kept) this.keep(manifold, a, b);
    this.#block = this.#blocks.find(manifold);
    this.#taken = 0;
    return kept && this.#counts[this.#block]! > 0;
  }

  /** Where the first of them lay on B. */
  first(k: 0 | 1 | 2): number {
    return this.#floats[this.#block * BLOCK + k]!;
  }

  /** Writes what the nearest of them carries on to `point`, by pointer: nothing where there is none. */
  take(point: number, x: number, y: number, z: number, nx: number, ny: number, nz: number): void {
    const found = this.#nearest(x, y, z, nx, ny, nz);
    const { HEAP32 } = this.#ammo;
    const to = (point >> 2) + CARRIED;
    if (found < 0) {
      for (let i = 0; i < WORDS; i++) HEAP32[to + i] = 0;
      return;
    }
    this.#taken |= 1 << found;
    const from = this.#block * BLOCK + found * SIZE + KEPT;
    const words = this.#words;
    for (let i = 0; i < WORDS; i++) HEAP32[to + i] = words[from + i]!;
  }

  #nearest(x: number, y: number, z: number, nx: number, ny: number, nz: number): number {
    const f = this.#floats;
    let least = Infinity;
    let found = -1;
    for (let i = 0; i < this.#counts[this.#block]!; i++) {
      if (this.#taken & (1 << i)) continue;
      const p = this.#block * BLOCK + i * SIZE;
      const n = p + NORMAL;
      if (f[n]! * nx + f[n + 1]! * ny + f[n + 2]! * nz < SAME_SIDE) continue;
      const apart = (f[p]! - x) ** 2 + (f[p + 1]! - y) ** 2 + (f[p + 2]! - z) ** 2;
      if (apart < least) {
        least = apart;
        found = i;
      }
    }
    return found;
  }
}
