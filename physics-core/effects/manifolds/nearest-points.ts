import { hypot } from '../../base/exact/index.js';
import { dot3 } from '../../base/flat-math.js';
import type { PlacedForm } from './placed-form.js';
import { Simplex } from './simplex.js';

/** Of the squared distance: nearer than so the search does not look. */
const NEAR_ENOUGH = 1e-12;
const MOST_ROUNDS = 48;

/** Share of their reach by which two forms are drawn apart to be searched, so that they do not overlap. */
const APART = 1e-2;

/** How often the direction is found anew: each time its error shrinks by some APART. */
const MOST_TURNS = 8;
const MOST_TRIES = 12;

/** Nor is it looked for on, where it is better by less, metres. */
const NO_FARTHER = 1e-10;

/** A direction that turns less is found, radians. */
const STEADY = 1e-7;

/**
 * Gilbert, Johnson and Keerthi 1988: the points of two forms nearest to each other, in double precision. Forms that
 * overlap are drawn apart first, along a direction that is made better by what is found.
 */
export class NearestPoints {
  readonly #simplex = new Simplex();
  /** From B to A, a unit vector, and the point on B. Of what is too far apart, the direction that says so. */
  readonly normal = new Float64Array(3);
  readonly onB = new Float64Array(3);
  /** Along the normal, metres; below 0 they overlap. */
  distance = 0;
  readonly #shift = new Float64Array(3);
  /** By how much what was taken may still be farther than the nearest, metres. */
  #gap = Infinity;
  /** From B to A, as it was taken. */
  readonly #taken = new Float64Array(3);
  /** Forms without what is round about them that are farther apart than this are none of the caller's, metres. */
  #far = Infinity;
  readonly #best = { distance: -Infinity, normal: new Float64Array(3), onB: new Float64Array(3) };

  /** `normal` holds a guess. False: nothing was found, or they are farther apart than `limit`, metres. */
  find(a: PlacedForm, b: PlacedForm, limit = Infinity): boolean {
    const { normal } = this;
    const best = this.#best;
    best.distance = -Infinity;
    const size = Math.min(a.form.reach, b.form.reach);
    let between = this.#between(a, b);
    for (let turn = 0, tries = 0; turn < MOST_TURNS && tries < MOST_TRIES; tries++) {
      const x = normal[0]!;
      const y = normal[1]!;
      const z = normal[2]!;
      const apart = APART * size * (1 + tries) - between - a.form.round - b.form.round;
      for (let i = 0; i < 3; i++) this.#shift[i] = Math.max(0, apart) * normal[i]!;
      this.#far = apart > 0 ? Infinity : limit + a.form.round + b.form.round;
      const found = this.#search(a, b);
      if (found !== 'far' && this.#gap < Infinity) this.#turnNormal();
      if (found === 'far') return false;
      between = this.#between(a, b);
      if (found === 'nothing') continue;
      turn++;
      const farther = between - best.distance;
      if (farther > 0) this.#keepBest(between);
      const change = Math.abs(normal[0]! - x) + Math.abs(normal[1]! - y) + Math.abs(normal[2]! - z);
      if (change < STEADY || apart <= 0 || farther < NO_FARTHER) break;
    }
    if (best.distance === -Infinity) return false;
    normal.set(best.normal);
    this.onB.set(best.onB);
    this.distance = best.distance;
    return true;
  }

  /** How far apart they are along the normal, metres: of all directions, the one of the nearest points has most. */
  #between(a: PlacedForm, b: PlacedForm): number {
    const x = this.normal[0]!;
    const y = this.normal[1]!;
    const z = this.normal[2]!;
    return -b.height(x, y, z) - a.height(-x, -y, -z);
  }

  #keepBest(distance: number): void {
    const best = this.#best;
    best.distance = distance;
    best.normal.set(this.normal);
    best.onB.set(this.onB);
  }

  #search(a: PlacedForm, b: PlacedForm): 'found' | 'nothing' | 'far' {
    const simplex = this.#simplex;
    const { nearest } = simplex;
    nearest.set(this.normal);
    simplex.count = 0;
    this.#gap = Infinity;
    let before = Infinity;
    for (let round = 0; round < MOST_ROUNDS; round++) {
      const square = dot3(nearest, 0, nearest, 0);
      // Corners too near each other no longer say where what is nearest lies: rims come so close that only rounding is left.
      if (square >= before) break;
      const at = 3 * simplex.count;
      this.#support(a, b, at);
      const { w } = simplex;
      const along = nearest[0]! * w[at]! + nearest[1]! * w[at + 1]! + nearest[2]! * w[at + 2]!;
      if (round > 0) {
        const size = Math.sqrt(square);
        // What lies beyond this corner is no nearer than that.
        if (along > this.#far * size) return this.#separate(size);
        const gap = (square - along) / size;
        if (gap < this.#gap) this.#take(gap);
        if (square - along <= NEAR_ENOUGH * square) break;
        before = square;
      }
      if (this.#known(at)) break;
      simplex.count++;
      if (!simplex.reduce()) return 'nothing';
      if (dot3(nearest, 0, nearest, 0) < 1e-24) return 'nothing';
    }
    return this.#gap < Infinity ? 'found' : 'nothing';
  }

  #separate(size: number): 'far' {
    for (let i = 0; i < 3; i++) this.normal[i] = this.#simplex.nearest[i]! / size;
    return 'far';
  }

  /** A corner that is there already says that no other is nearer. */
  #known(at: number): boolean {
    const { w } = this.#simplex;
    for (let i = 0; i < at; i += 3)
      if (w[i] === w[at] && w[i + 1] === w[at + 1] && w[i + 2] === w[at + 2]) return true;
    return false;
  }

  #support(a: PlacedForm, b: PlacedForm, at: number): void {
    const { nearest, w, a: onA, b: onB } = this.#simplex;
    a.support(nearest, -1, onA, at);
    b.support(nearest, 1, onB, at);
    const shift = this.#shift;
    w[at] = onA[at]! + shift[0]! - onB[at]!;
    w[at + 1] = onA[at + 1]! + shift[1]! - onB[at + 1]!;
    w[at + 2] = onA[at + 2]! + shift[2]! - onB[at + 2]!;
  }

  #take(gap: number): void {
    const { nearest, share, count, b } = this.#simplex;
    this.#gap = gap;
    let x = 0;
    let y = 0;
    let z = 0;
    for (let i = 0; i < count; i++) {
      x += share[i]! * b[3 * i]!;
      y += share[i]! * b[3 * i + 1]!;
      z += share[i]! * b[3 * i + 2]!;
    }
    write3(this.onB, x, y, z);
    write3(this.#taken, nearest[0]!, nearest[1]!, nearest[2]!);
  }

  /** To where what was taken last lies. */
  #turnNormal(): void {
    const taken = this.#taken;
    const size = hypot(taken[0]!, taken[1]!, taken[2]!);
    write3(this.normal, taken[0]! / size, taken[1]! / size, taken[2]! / size);
  }
}

function write3(out: Float64Array, x: number, y: number, z: number): void {
  out[0] = x;
  out[1] = y;
  out[2] = z;
}
