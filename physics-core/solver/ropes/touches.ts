import {
  GRIP_COMPLIANCE,
  LINK_COMPLIANCE,
  ROPE_MISS,
  ROPE_NEAR,
  SHARE_TRIES,
} from '../tolerances.js';
import { HELD, type Strand } from './strand.js';

const NONE = 0;
const STICKS = 1;
const SLIPS = 2;

const tried = new Float64Array(3);

/**
 * What the points of a strand touch, in a round of the search. It pushes them away as if it gave way a little, and holds them
 * along the surface as springs would that remember where they were taut in the last step: as hard as Coulomb's law says at
 * most. So what sticks does not creep, and what slips is held by what presses it on.
 */
export class Touches {
  readonly #strand: Strand;
  readonly #state: Uint8Array;
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

  constructor(strand: Strand) {
    const { points } = strand;
    this.#strand = strand;
    this.#state = new Uint8Array(points);
    this.#compliance = new Float64Array(points);
    this.#grip = new Float64Array(points);
    this.#depths = new Float64Array(points);
    this.#most = new Float64Array(points);
    this.#ways = new Float64Array(3 * points);
    this.#shares = new Float64Array(points);
    this.#trials = new Float64Array(3 * points);
  }

  begin(dt: number): void {
    const { touches, holders, masses, yields, presses, pressed, rubs, frictions, points } =
      this.#strand;
    this.any = false;
    this.#state.fill(NONE);
    for (let i = 0; i < points; i++) {
      const j = 3 * i;
      if (touches[i] && holders[i]! < HELD) {
        this.any = true;
        this.#most[i] = frictions[i]! * pressed[i]!;
        const own = dt / masses[i]!;
        this.#compliance[i] = LINK_COMPLIANCE * own + dt * yields[i]!;
        this.#grip[i] = GRIP_COMPLIANCE * own + dt * yields[i]!;
      } else presses[i] = rubs[j] = rubs[j + 1] = rubs[j + 2] = 0;
    }
  }

  /** By the velocities found so far. */
  read(dt: number, first: boolean): void {
    if (!this.any) return;
    const { touches, holders, points } = this.#strand;
    for (let i = 0; i < points; i++) if (touches[i] && holders[i]! < HELD) this.#read(i, dt, first);
  }

  #read(i: number, dt: number, first: boolean): void {
    const { normals, gaps, surfaces, found, masses, presses, rubs, rubbed } = this.#strand;
    const ways = this.#ways;
    const j = 3 * i;
    let away = 0;
    for (let k = j; k < j + 3; k++) away += normals[k]! * (ways[k] = found[k]! - surfaces[k]!);
    const gap = gaps[i]! + dt * away;
    const before = presses[i]!;
    const pressed = before > 0 ? before * dt > gap * masses[i]! : gap < -ROPE_MISS;
    if (!pressed && !(first && gaps[i]! <= ROPE_NEAR)) {
      this.#state[i] = presses[i] = rubs[j] = rubs[j + 1] = rubs[j + 2] = 0;
      return;
    }
    this.#depths[i] = gap + this.#compliance[i]! * before;
    let along = 0;
    for (let k = j; k < j + 3; k++) along += normals[k]! * rubbed[k]!;
    let square = 0;
    for (let k = j; k < j + 3; k++) {
      const slip = ways[k]! - away * normals[k]!;
      rubs[k] = rubbed[k]! - along * normals[k]! - (dt * slip) / this.#grip[i]!;
      this.#trials[k] = rubs[k]!;
      square += rubs[k]! ** 2;
    }
    const most = this.#most[i]!;
    if (square <= most * most) {
      this.#state[i] = STICKS;
      return;
    }
    this.#state[i] = SLIPS;
    const length = Math.sqrt(square);
    this.#shares[i] = most / length;
    for (let k = j; k < j + 3; k++) {
      ways[k] = rubs[k]! / length;
      rubs[k] = most * ways[k]!;
    }
  }

  /** Adds to the block of a point and to what is missing of its momentum. */
  resist(i: number, blocks: Float64Array, at: number, rest: Float64Array, dt: number): void {
    const state = this.#state[i]!;
    if (state === NONE) return;
    const { normals, presses, rubs } = this.#strand;
    const ways = this.#ways;
    const j = 3 * i;
    const stiff = 1 / this.#compliance[i]!;
    const slips = state === SLIPS;
    const hold = (dt / this.#grip[i]!) * (slips ? this.#shares[i]! : 1);
    for (let k = 0; k < 3; k++) {
      const n = normals[j + k]!;
      rest[j + k]! += (presses[i]! - stiff * this.#depths[i]!) * n + rubs[j + k]!;
    }
    for (let r = 0; r < 3; r++)
      for (let c = 0; c < 3; c++) {
        const n = normals[j + c]!;
        let share = (r === c ? 1 : 0) - normals[j + r]! * n;
        if (slips) share -= ways[j + r]! * ways[j + c]!;
        blocks[at + 3 * r + c]! += dt * stiff * normals[j + r]! * n + hold * share;
      }
  }

  /** How it is pushed once it goes on by `change`. */
  follow(change: Float64Array, share: number, dt: number): void {
    if (!this.any) return;
    const { normals, presses, points } = this.#strand;
    for (let i = 0; i < points; i++) {
      if (this.#state[i] === NONE) continue;
      const j = 3 * i;
      let away = 0;
      for (let k = j; k < j + 3; k++) away += normals[k]! * change[k]!;
      presses[i]! -= (share * (this.#depths[i]! + dt * away)) / this.#compliance[i]!;
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
    const { normals, rubs, points } = this.#strand;
    let slope = -(1 - share) * inertia;
    for (let i = 0; i < points; i++) {
      const state = this.#state[i]!;
      if (state === NONE) continue;
      const j = 3 * i;
      let away = 0;
      let slipping = 0;
      for (let k = j; k < j + 3; k++) {
        away += normals[k]! * change[k]!;
        slipping += this.#ways[k]! * change[k]!;
      }
      const hold = (dt / this.#grip[i]!) * (state === SLIPS ? this.#shares[i]! : 1);
      let square = 0;
      for (let k = j; k < j + 3; k++) {
        const along = change[k]! - away * normals[k]!;
        tried[k - j] = this.#trials[k]! - (share * dt * along) / this.#grip[i]!;
        square += tried[k - j]! ** 2;
      }
      const most = this.#most[i]!;
      const within = square > most * most ? most / Math.sqrt(square) : 1;
      for (let k = j; k < j + 3; k++) {
        const along = change[k]! - away * normals[k]!;
        const aside = along - (state === SLIPS ? slipping * this.#ways[k]! : 0);
        slope -= along * (within * tried[k - j]! - (rubs[k]! - hold * aside));
      }
    }
    return slope;
  }
}
