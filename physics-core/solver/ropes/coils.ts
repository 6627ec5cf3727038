import { dot3 } from '../../base/flat-math.js';
import { grown, grownInt } from '../../base/grown.js';
import { HELD, type Strand } from './strand.js';

/** Numbers of each pair in what is kept. */
const KEPT = 9;

const slip = new Float64Array(3);
const push = new Float64Array(3);

/**
 * Where a strand meets itself in a step: pairs of links, each with one place on either. What such a pair gave in the last step
 * it gives again from the start; what is missing of that is found one pair at a time, beside the links and all else that is
 * touched.
 */
export class Coils {
  readonly #strand: Strand;
  readonly #free: Float64Array;
  count = 0;
  friction = 0;
  /** Of each pair: its links, and the share of each that is before its place. */
  links = new Int32Array(0);
  shares = new Float64Array(0);
  /** From the second to the first, and how far away that is when the step begins, metres. */
  normals = new Float64Array(0);
  gaps = new Float64Array(0);
  /** What the second gives the first, N s: along the normal, and across it. */
  presses = new Float64Array(0);
  rubs = new Float64Array(0);
  /** m/s for each N s. */
  #gives = new Float64Array(0);

  constructor(strand: Strand) {
    this.#strand = strand;
    this.#free = new Float64Array(3 * strand.points);
  }

  /** Whether anything of it pressed on itself in the last step. */
  get press(): boolean {
    for (let c = 0; c < this.count; c++) if (this.presses[c]! > 0) return true;
    return false;
  }

  clear(): void {
    this.count = 0;
  }

  /** One more between two links; returns its number. */
  add(i: number, j: number, s: number, t: number): number {
    const c = this.count++;
    if (this.gaps.length < this.count) this.#grow(2 * this.count + 16);
    this.links[2 * c] = i;
    this.links[2 * c + 1] = j;
    this.shares[2 * c] = s;
    this.shares[2 * c + 1] = t;
    this.presses[c] = this.rubs[3 * c] = this.rubs[3 * c + 1] = this.rubs[3 * c + 2] = 0;
    return c;
  }

  #grow(room: number): void {
    this.links = grownInt(this.links, 2 * room);
    this.shares = grown(this.shares, 2 * room);
    this.normals = grown(this.normals, 3 * room);
    this.gaps = grown(this.gaps, room);
    this.presses = grown(this.presses, room);
    this.rubs = grown(this.rubs, 3 * room);
    this.#gives = grown(this.#gives, room);
  }

  /** A step begins with what was given in the last one. */
  begin(): void {
    for (let c = 0; c < this.count; c++) this.#gives[c] = this.#givesOf(c);
    this.#free.set(this.#strand.free);
    this.give();
  }

  /** What is given by now acts from the start. */
  give(): void {
    const { free, masses, holders } = this.#strand;
    const { links, shares } = this;
    free.set(this.#free);
    for (let c = 0; c < this.count; c++) {
      for (let k = 0; k < 3; k++)
        push[k] = this.presses[c]! * this.normals[3 * c + k]! + this.rubs[3 * c + k]!;
      for (let n = 0; n < 4; n++) {
        const side = n >> 1;
        const i = links[2 * c + side]! + (n & 1);
        if (holders[i] === HELD) continue;
        const share = n & 1 ? shares[2 * c + side]! : 1 - shares[2 * c + side]!;
        const by = (side === 0 ? share : -share) / masses[i]!;
        for (let k = 0; k < 3; k++) free[3 * i + k]! += by * push[k]!;
      }
    }
  }

  #givesOf(c: number): number {
    const { masses, holders } = this.#strand;
    let gives = 0;
    for (let n = 0; n < 4; n++) {
      const i = this.links[2 * c + (n >> 1)]! + (n & 1);
      const s = this.shares[2 * c + (n >> 1)]!;
      const share = n & 1 ? s : 1 - s;
      if (holders[i]! < HELD) gives += (share * share) / masses[i]!;
    }
    return gives;
  }

  /** Goes over all pairs once; returns how far the worst was off, metres. */
  sweep(dt: number, back: boolean): number {
    let most = 0;
    const { count } = this;
    for (let n = 0; n < count; n++) {
      const off = this.#meet(back ? count - 1 - n : n, dt);
      if (off > most) most = off;
    }
    return most;
  }

  #meet(c: number, dt: number): number {
    const { normals, presses, rubs, friction, shares } = this;
    const { found } = this.#strand;
    const gives = this.#gives[c]!;
    if (!(gives > 0)) return 0;
    const i = 3 * this.links[2 * c]!;
    const j = 3 * this.links[2 * c + 1]!;
    const s = shares[2 * c]!;
    const t = shares[2 * c + 1]!;
    for (let k = 0; k < 3; k++)
      slip[k] =
        found[i + k]! +
        s * (found[i + 3 + k]! - found[i + k]!) -
        found[j + k]! -
        t * (found[j + 3 + k]! - found[j + k]!);
    const n = 3 * c;
    const away = dot3(normals, n, slip, 0);
    const before = presses[c]!;
    const press = Math.max(0, before - (away + this.gaps[c]! / dt) / gives);
    if (press === 0 && before === 0) return 0;
    presses[c] = press;
    const most = friction * press;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      push[k] = rubs[n + k]! - (slip[k]! - away * normals[n + k]!) / gives;
      square += push[k]! ** 2;
    }
    const within = square > most * most ? most / Math.sqrt(square) : 1;
    let change = 0;
    for (let k = 0; k < 3; k++) {
      const rub = within * push[k]!;
      push[k] = (press - before) * normals[n + k]! + rub - rubs[n + k]!;
      rubs[n + k] = rub;
      change += push[k]! ** 2;
    }
    this.#push(i, 1 - s);
    this.#push(i + 3, s);
    this.#push(j, t - 1);
    this.#push(j + 3, -t);
    return Math.sqrt(change) * gives * dt;
  }

  #push(at: number, share: number): void {
    const { found, masses, holders } = this.#strand;
    if (share === 0 || holders[at / 3]! >= HELD) return;
    const by = share / masses[at / 3]!;
    for (let k = 0; k < 3; k++) found[at + k]! += by * push[k]!;
  }

  // ---- going back -----------------------------------------------------------------------------------------------------

  /** What presses. */
  save(): Float64Array {
    const kept: number[] = [];
    for (let c = 0; c < this.count; c++) {
      if (this.presses[c] === 0) continue;
      kept.push(...this.links.subarray(2 * c, 2 * c + 2), this.presses[c]!);
      for (const all of [this.normals, this.rubs]) kept.push(...all.subarray(3 * c, 3 * c + 3));
    }
    return Float64Array.from(kept);
  }

  load(kept: Float64Array): void {
    this.clear();
    for (let at = 0; at + KEPT <= kept.length; at += KEPT) {
      const c = this.add(kept[at]!, kept[at + 1]!, 0, 0);
      this.presses[c] = kept[at + 2]!;
      this.normals.set(kept.subarray(at + 3, at + 6), 3 * c);
      this.rubs.set(kept.subarray(at + 6, at + 9), 3 * c);
    }
  }
}
