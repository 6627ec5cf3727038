import { dot3 } from '../../base/flat-math.js';
import { SPOTS } from '../../solver/ropes/spots.js';
import { MET, METS, type Obstacles } from '../particles/collide/obstacles.js';
import { HALVINGS, LEVEL, STEEP } from './tolerances.js';

const met = new Float64Array(METS);
const at = new Float64Array(3);
const start = new Float64Array(3);
const end = new Float64Array(3);
const way = new Float64Array(3);

/** What lies near to a link, numbers of each: its share of the way, its slot, its gap, its normal and its point. */
export const SPOT = { share: 0, slot: 1, gap: 2, normal: 3, point: 6 } as const;
const NUMBERS = 9;

/**
 * Where a link is nearest to bodies between its points. How far something convex is from a place on it is a convex function of
 * that place: it falls from an end of the link on, and rises again where the nearest place is passed. Where the link lies along
 * a face, all of that is as near: so it is looked for from either end, and found where the face ends.
 */
export class OnLink {
  readonly #obstacles: Obstacles;
  readonly found = new Float64Array(NUMBERS * SPOTS);
  /** From the end that is looked from: where it was nearest so far. */
  #share = 0;

  constructor(obstacles: Obstacles) {
    this.#obstacles = obstacles;
  }

  /** No farther away than `reach` from its middle line; places nearer to each other than `apart` are one. Answers how many. */
  look(one: Float64Array, two: Float64Array, reach: number, apart: number): number {
    const { found } = this;
    let count = 0;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      way[k] = two[k]! - one[k]!;
      square += way[k]! ** 2;
    }
    const long = Math.sqrt(square);
    if (!(long > 0)) return 0;
    if (this.#from(one, two, long, reach) && this.#note(one, this.#share, long, reach, count))
      count++;
    if (this.#from(two, one, long, reach)) {
      const share = 1 - this.#share;
      const known = found[SPOT.share]!;
      const isOne = count > 0 && found[SPOT.slot] === met[MET.body];
      if (isOne && Math.abs(share - known) * long < apart)
        this.#note(one, (share + known) / 2, long, reach, 0);
      else if (this.#note(one, share, long, reach, count)) count++;
    }
    return count;
  }

  /** Whether something is nearest between both ends, as seen from the first. It stays in `met`. */
  #from(one: Float64Array, two: Float64Array, long: number, reach: number): boolean {
    for (let k = 0; k < 3; k++) {
      start[k] = one[k]!;
      end[k] = two[k]!;
    }
    if (!this.#obstacles.meet(start, end, reach, met, 1, 1)) return false;
    const slot = met[MET.body]!;
    let low = met[MET.share]!;
    let high = 1;
    if (!(this.#slope() < -LEVEL * long)) return false;
    let isFound = false;
    for (let n = 0; n < HALVINGS; n++) {
      const middle = (low + high) / 2;
      for (let k = 0; k < 3; k++) at[k] = start[k]! + middle * (end[k]! - start[k]!);
      const isNear = this.#obstacles.meet(at, at, reach, met, 1, 1) && met[MET.body] === slot;
      if (isNear && this.#slope() < -LEVEL * long) low = middle;
      else high = middle;
      if (isNear && high === middle) isFound = true;
    }
    this.#share = high;
    met[MET.body] = slot;
    return isFound;
  }

  /** By how much what was met is farther away at the end that is looked to than where it was met, were it flat. */
  #slope(): number {
    let slope = 0;
    for (let k = 0; k < 3; k++) slope += met[MET.normal + k]! * (end[k]! - start[k]!);
    return slope;
  }

  /** Which way it is pushed there: across the link, as one that lies on an edge is. */
  #note(one: Float64Array, share: number, long: number, reach: number, n: number): boolean {
    for (let k = 0; k < 3; k++) at[k] = one[k]! + share * way[k]!;
    if (!this.#obstacles.meet(at, at, reach, met, 1, 1)) return false;
    const { found } = this;
    const i = NUMBERS * n;
    const along = dot3(met, MET.normal, way, 0) / (long * long);
    let gap = 0;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      const normal = met[MET.normal + k]! - along * way[k]!;
      gap += met[MET.normal + k]! * (at[k]! - met[MET.point + k]!);
      found[i + SPOT.normal + k] = normal;
      square += normal * normal;
    }
    const across = Math.sqrt(square);
    if (!(across > STEEP)) return false;
    gap /= across;
    for (let k = 0; k < 3; k++) {
      found[i + SPOT.normal + k]! /= across;
      found[i + SPOT.point + k] = at[k]! - gap * found[i + SPOT.normal + k]!;
    }
    found[i + SPOT.share] = share;
    found[i + SPOT.slot] = met[MET.body]!;
    found[i + SPOT.gap] = gap;
    return true;
  }
}
