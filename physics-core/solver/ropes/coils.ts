import { grown, grownInt } from '../../base/grown.js';
import { SIDE } from '../joints/blocks.js';
import { HELD, type Strand } from './strand.js';

const BLOCK = SIDE * SIDE;

/** Numbers of each pair in what is kept. */
const KEPT = 9;

const push = new Float64Array(3);

/**
 * Where a strand meets itself in a step: pairs of links, each with one place on either. What such a pair gave in the last step
 * it gives again from the start; what is missing of that is found one pair at a time, beside the links and all else that is
 * touched.
 */
export class Coils {
  readonly #strand: Strand;
  readonly #free: Float64Array;
  /** Of each point, 1/kg: 0 where it is held, with its body where it is tied. */
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
  get pressed(): boolean {
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

  /**
   * Goes over all pairs once; returns how far the worst was off, metres. Half of what it costs that a rope meets itself is spent
   * here: in pieces, it takes twice as long.
   */
  sweep(dt: number, back: boolean): number {
    const { links, shares, normals, gaps, presses, rubs, friction, count } = this;
    const { found } = this.#strand;
    const allGives = this.#gives;
    const lightness = this.#lightness;
    let most = 0;
    for (let m = 0; m < count; m++) {
      const c = back ? count - 1 - m : m;
      const gives = allGives[c]!;
      if (!(gives > 0)) continue;
      const first = links[2 * c]!;
      const second = links[2 * c + 1]!;
      const i = 3 * first;
      const j = 3 * second;
      const s = shares[2 * c]!;
      const t = shares[2 * c + 1]!;
      const a = 1 - s;
      const b = 1 - t;
      const x = a * found[i]! + s * found[i + 3]! - b * found[j]! - t * found[j + 3]!;
      const y = a * found[i + 1]! + s * found[i + 4]! - b * found[j + 1]! - t * found[j + 4]!;
      const z = a * found[i + 2]! + s * found[i + 5]! - b * found[j + 2]! - t * found[j + 5]!;
      const n = 3 * c;
      const nx = normals[n]!;
      const ny = normals[n + 1]!;
      const nz = normals[n + 2]!;
      const away = x * nx + y * ny + z * nz;
      const before = presses[c]!;
      const press = Math.max(0, before - (away + gaps[c]! / dt) / gives);
      if (press === 0 && before === 0) continue;
      presses[c] = press;
      // What would hold it across, and as much of that as Coulomb's law allows.
      const u = rubs[n]! - (x - away * nx) / gives;
      const v = rubs[n + 1]! - (y - away * ny) / gives;
      const w = rubs[n + 2]! - (z - away * nz) / gives;
      const square = u * u + v * v + w * w;
      const bound = friction * press;
      const within = square > bound * bound ? bound / Math.sqrt(square) : 1;
      const px = (press - before) * nx + within * u - rubs[n]!;
      const py = (press - before) * ny + within * v - rubs[n + 1]!;
      const pz = (press - before) * nz + within * w - rubs[n + 2]!;
      rubs[n] = within * u;
      rubs[n + 1] = within * v;
      rubs[n + 2] = within * w;
      const i0 = a * lightness[first]!;
      const i1 = s * lightness[first + 1]!;
      const j0 = b * lightness[second]!;
      const j1 = t * lightness[second + 1]!;
      found[i]! += i0 * px;
      found[i + 1]! += i0 * py;
      found[i + 2]! += i0 * pz;
      found[i + 3]! += i1 * px;
      found[i + 4]! += i1 * py;
      found[i + 5]! += i1 * pz;
      found[j]! -= j0 * px;
      found[j + 1]! -= j0 * py;
      found[j + 2]! -= j0 * pz;
      found[j + 3]! -= j1 * px;
      found[j + 4]! -= j1 * py;
      found[j + 5]! -= j1 * pz;
      const off = Math.sqrt(px * px + py * py + pz * pz) * gives * dt;
      if (off > most) most = off;
    }
    return most;
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
