import { dot3 } from '../../base/flat-math.js';
import {
  GRIP_COMPLIANCE,
  LINK_COMPLIANCE,
  ROPE_MISS,
  ROPE_NEAR,
  SHARE_TRIES,
} from '../tolerances.js';
import { HELD, type Strand } from './strand.js';
import type { Spots } from './spots.js';

const NONE = 0;
const STICKS = 1;
const SLIPS = 2;

const tried = new Float64Array(3);
const moved = new Float64Array(3);

/**
 * What spots of a strand touch, in a round of the search. It pushes them away as if it gave way a little, and holds them
 * along the surface as springs would that remember where they were taut in the last step: as hard as Coulomb's law says at
 * most. So what sticks does not creep, and what slips is held by what presses it on. Between two points each has its share
 * of that, as much as it has of the place.
 */
export class Touches {
  readonly spots: Spots;
  readonly #strand: Strand;
  readonly #state: Uint8Array;
  /** What a push of 1 N s does to the speed of each, 1/kg. */
  readonly #gives: Float64Array;
  /** Metres for each N s: along the normal, and along the surface. */
  readonly #compliance: Float64Array;
  readonly #grip: Float64Array;
  /** How far each comes too deep, metres. */
  readonly #depths: Float64Array;
  /** What it may be rubbed by at most, N s: by how it was pressed in the last step. */
  readonly #most: Float64Array;
  /** Which way it is rubbed where it slips, and how much of what would hold it. */
  readonly #ways: Float64Array;
  readonly #shares: Float64Array;
  /** What would hold it, N s. */
  readonly #trials: Float64Array;
  /** Whether it touches anything. */
  any = false;
  /**
   * What slips resists a change of its speed, too, as if friction grew with that: more than it does, so that the energy of the
   * round bounds that of the search from above. By what friction does, a round that ends where something comes to a stand
   * would be followed by others that end there, too.
   */
  cautious = false;

  constructor(strand: Strand, spots: Spots) {
    const { count } = spots;
    this.spots = spots;
    this.#strand = strand;
    this.#state = new Uint8Array(count);
    this.#gives = new Float64Array(count);
    this.#compliance = new Float64Array(count);
    this.#grip = new Float64Array(count);
    this.#depths = new Float64Array(count);
    this.#most = new Float64Array(count);
    this.#ways = new Float64Array(3 * count);
    this.#shares = new Float64Array(count);
    this.#trials = new Float64Array(3 * count);
  }

  begin(dt: number): void {
    const { touches, yields, presses, pressed, rubs, frictions, count } = this.spots;
    this.any = false;
    if (this.spots.recent === 0) return;
    this.#state.fill(NONE);
    for (let c = 0; c < count; c++) {
      const j = 3 * c;
      const gives = touches[c] ? this.#givesOf(c) : 0;
      this.#gives[c] = gives;
      if (gives > 0) {
        this.any = true;
        this.#most[c] = frictions[c]! * pressed[c]!;
        const own = dt * gives;
        this.#compliance[c] = LINK_COMPLIANCE * own + dt * yields[c]!;
        this.#grip[c] = GRIP_COMPLIANCE * own + dt * yields[c]!;
      } else presses[c] = rubs[j] = rubs[j + 1] = rubs[j + 2] = 0;
    }
  }

  /** By what its points weigh; 0: nothing moves any of it. */
  #givesOf(c: number): number {
    const { holders, masses } = this.#strand;
    const i = this.spots.firsts[c]!;
    const share = this.spots.shares[c]!;
    let gives = 0;
    if (holders[i] !== HELD) gives += (1 - share) ** 2 / masses[i]!;
    if (share > 0 && holders[i + 1] !== HELD) gives += share ** 2 / masses[i + 1]!;
    return gives;
  }

  /** By the velocities found so far. */
  read(dt: number, first: boolean): void {
    if (!this.any) return;
    const { count } = this.spots;
    for (let c = 0; c < count; c++) if (this.#gives[c]! > 0) this.#read(c, dt, first);
  }

  #read(c: number, dt: number, first: boolean): void {
    const { firsts, shares, normals, gaps, surfaces, presses, rubs, rubbed } = this.spots;
    const { found } = this.#strand;
    const ways = this.#ways;
    const j = 3 * c;
    const share = shares[c]!;
    const one = 3 * firsts[c]!;
    const two = share > 0 ? one + 3 : one;
    let away = 0;
    for (let k = 0; k < 3; k++) {
      const v = found[one + k]!;
      ways[j + k] = v + share * (found[two + k]! - v) - surfaces[j + k]!;
      away += normals[j + k]! * ways[j + k]!;
    }
    const gap = gaps[c]! + dt * away;
    const before = presses[c]!;
    const pressed = before > 0 ? before * dt * this.#gives[c]! > gap : gap < -ROPE_MISS;
    if (!pressed && !(first && gaps[c]! <= ROPE_NEAR)) {
      this.#state[c] = presses[c] = rubs[j] = rubs[j + 1] = rubs[j + 2] = 0;
      return;
    }
    this.#depths[c] = gap + this.#compliance[c]! * before;
    let along = 0;
    for (let k = j; k < j + 3; k++) along += normals[k]! * rubbed[k]!;
    let square = 0;
    for (let k = j; k < j + 3; k++) {
      const slip = ways[k]! - away * normals[k]!;
      rubs[k] = rubbed[k]! - along * normals[k]! - (dt * slip) / this.#grip[c]!;
      this.#trials[k] = rubs[k]!;
      square += rubs[k]! ** 2;
    }
    const most = this.#most[c]!;
    if (square <= most * most) {
      this.#state[c] = STICKS;
      return;
    }
    this.#state[c] = SLIPS;
    const length = Math.sqrt(square);
    this.#shares[c] = most / length;
    for (let k = j; k < j + 3; k++) {
      ways[k] = rubs[k]! / length;
      rubs[k] = most * ways[k]!;
    }
  }

  acts(c: number): boolean {
    return this.#state[c] !== NONE;
  }

  /** Adds such a share of what it pushes by to what is missing of a momentum. */
  press(c: number, share: number, rest: Float64Array, at: number): void {
    const { normals, presses, rubs } = this.spots;
    const j = 3 * c;
    const press = presses[c]! - this.#depths[c]! / this.#compliance[c]!;
    for (let k = 0; k < 3; k++) rest[at + k]! += share * (press * normals[j + k]! + rubs[j + k]!);
  }

  /** Adds such a share of what resists a change of its velocity to a block. */
  resist(c: number, share: number, blocks: Float64Array, at: number, dt: number): void {
    const { normals } = this.spots;
    const ways = this.#ways;
    const j = 3 * c;
    const slips = this.#state[c] === SLIPS;
    const stiff = (share * dt) / this.#compliance[c]!;
    const hold = ((share * dt) / this.#grip[c]!) * (slips ? this.#shares[c]! : 1);
    for (let r = 0; r < 3; r++)
      for (let k = 0; k < 3; k++) {
        const n = normals[j + k]!;
        let along = (r === k ? 1 : 0) - normals[j + r]! * n;
        if (slips && !this.cautious) along -= ways[j + r]! * ways[j + k]!;
        blocks[at + 3 * r + k]! += stiff * normals[j + r]! * n + hold * along;
      }
  }

  /** Of a change of each point, that of a spot, to `moved`. */
  #moves(change: Float64Array, c: number): void {
    const share = this.spots.shares[c]!;
    const one = 3 * this.spots.firsts[c]!;
    const two = share > 0 ? one + 3 : one;
    for (let k = 0; k < 3; k++)
      moved[k] = change[one + k]! + share * (change[two + k]! - change[one + k]!);
  }

  /** How it is pushed once it goes on by `change`. */
  follow(change: Float64Array, share: number, dt: number): void {
    if (!this.any) return;
    const { normals, presses, count } = this.spots;
    for (let c = 0; c < count; c++) {
      if (this.#state[c] === NONE) continue;
      this.#moves(change, c);
      const away = dot3(normals, 3 * c, moved, 0);
      presses[c]! -= (share * (this.#depths[c]! + dt * away)) / this.#compliance[c]!;
    }
  }

  /**
   * How far a round may go on by `change`, as a share of it, at most all of it: friction changes its way where a point comes
   * to a stand, and that one does so here. `inertia`: of the change, J s²/s².
   */
  share(change: Float64Array, inertia: number, dt: number): number {
    if (!this.any || !(this.#slope(change, 1, inertia, dt) > 0)) return 1;
    let low = 0;
    let high = 1;
    for (let n = 0; n < SHARE_TRIES; n++) {
      const middle = (low + high) / 2;
      if (this.#slope(change, middle, inertia, dt) > 0) high = middle;
      else low = middle;
    }
    return high;
  }

  /** Of energy and friction together, along the change: it grows with the share, and is 0 where that is enough. */
  #slope(change: Float64Array, share: number, inertia: number, dt: number): number {
    const { normals, rubs, count } = this.spots;
    let slope = -(1 - share) * inertia;
    for (let c = 0; c < count; c++) {
      const state = this.#state[c]!;
      if (state === NONE) continue;
      const turns = state === SLIPS && !this.cautious;
      const j = 3 * c;
      this.#moves(change, c);
      const away = dot3(normals, j, moved, 0);
      const slipping = dot3(this.#ways, j, moved, 0);
      const hold = (dt / this.#grip[c]!) * (state === SLIPS ? this.#shares[c]! : 1);
      let square = 0;
      for (let k = 0; k < 3; k++) {
        const along = moved[k]! - away * normals[j + k]!;
        tried[k] = this.#trials[j + k]! - (share * dt * along) / this.#grip[c]!;
        square += tried[k]! ** 2;
      }
      const most = this.#most[c]!;
      const within = square > most * most ? most / Math.sqrt(square) : 1;
      for (let k = 0; k < 3; k++) {
        const along = moved[k]! - away * normals[j + k]!;
        const aside = along - (turns ? slipping * this.#ways[j + k]! : 0);
        slope -= along * (within * tried[k]! - (rubs[j + k]! - hold * aside));
      }
    }
    return slope;
  }
}
