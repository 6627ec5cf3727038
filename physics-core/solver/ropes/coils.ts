import { grown, grownInt } from '../../base/grown.js';
import { SIDE } from '../joints/blocks.js';
import { HELD, type Strand } from './strand.js';

const BLOCK = SIDE * SIDE;

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
  /** Of each point that nothing holds, 1/kg. */
  readonly #lightness: Float64Array;
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
    this.#lightness = new Float64Array(strand.points);
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

  /** A step begins with what was given in the last one. `inertias`: of the bodies that its points are tied to. */
  begin(inertias: Float64Array): void {
    const { holders, masses, points } = this.#strand;
    for (let i = 0; i < points; i++) {
      const holder = holders[i]!;
      // What a tied point gives way by is up to the search; here its body counts by its mass alone.
      const mass = masses[i]! + (holder >= 0 ? inertias[BLOCK * holder]! : 0);
      this.#lightness[i] = holder === HELD ? 0 : 1 / mass;
    }
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

  /** What would be done without is known again: the step may be found anew. */
  end(): void {
    this.#strand.free.set(this.#free);
  }

  #givesOf(c: number): number {
    let gives = 0;
    for (let n = 0; n < 4; n++) {
      const i = this.links[2 * c + (n >> 1)]! + (n & 1);
      const s = this.shares[2 * c + (n >> 1)]!;
      gives += (n & 1 ? s : 1 - s) ** 2 * this.#lightness[i]!;
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
    const { normals, presses, shares, links } = this;
    const { found } = this.#strand;
    const gives = this.#gives[c]!;
    if (!(gives > 0)) return 0;
    const i = 3 * links[2 * c]!;
    const j = 3 * links[2 * c + 1]!;
    const s = shares[2 * c]!;
    const t = shares[2 * c + 1]!;
    const a = 1 - s;
    const b = 1 - t;
    const x = a * found[i]! + s * found[i + 3]! - b * found[j]! - t * found[j + 3]!;
    const y = a * found[i + 1]! + s * found[i + 4]! - b * found[j + 1]! - t * found[j + 4]!;
    const z = a * found[i + 2]! + s * found[i + 5]! - b * found[j + 2]! - t * found[j + 5]!;
    const n = 3 * c;
    const away = x * normals[n]! + y * normals[n + 1]! + z * normals[n + 2]!;
    const before = presses[c]!;
    const press = Math.max(0, before - (away + this.gaps[c]! / dt) / gives);
    if (press === 0 && before === 0) return 0;
    presses[c] = press;
    slip[0] = x - away * normals[n]!;
    slip[1] = y - away * normals[n + 1]!;
    slip[2] = z - away * normals[n + 2]!;
    const change = this.#rub(c, press - before, gives);
    this.#push(i, a);
    this.#push(i + 3, s);
    this.#push(j, -b);
    this.#push(j + 3, -t);
    return change * gives * dt;
  }

  /** What it gives more than before, to `push`, once it is pressed by so much more and slips: returns how much that is, N s. */
  #rub(c: number, pressed: number, gives: number): number {
    const { normals, rubs } = this;
    const n = 3 * c;
    const most = this.friction * this.presses[c]!;
    const x = rubs[n]! - slip[0]! / gives;
    const y = rubs[n + 1]! - slip[1]! / gives;
    const z = rubs[n + 2]! - slip[2]! / gives;
    const square = x * x + y * y + z * z;
    const within = square > most * most ? most / Math.sqrt(square) : 1;
    push[0] = pressed * normals[n]! + within * x - rubs[n]!;
    push[1] = pressed * normals[n + 1]! + within * y - rubs[n + 1]!;
    push[2] = pressed * normals[n + 2]! + within * z - rubs[n + 2]!;
    rubs[n] = within * x;
    rubs[n + 1] = within * y;
    rubs[n + 2] = within * z;
    return Math.sqrt(push[0]! ** 2 + push[1]! ** 2 + push[2]! ** 2);
  }

  #push(at: number, share: number): void {
    if (share === 0) return;
    const { found } = this.#strand;
    const by = share * this.#lightness[at / 3]!;
    found[at]! += by * push[0]!;
    found[at + 1]! += by * push[1]!;
    found[at + 2]! += by * push[2]!;
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
