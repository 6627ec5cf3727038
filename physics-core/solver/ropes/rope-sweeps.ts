import { SIDE } from '../joints/blocks.js';
import { DenseLu } from '../matrix/dense-lu.js';
import { ROPE_SWEEPS } from '../tolerances.js';
import type { Links } from './links.js';
import { HELD, type Strand } from './strand.js';
import { SPOTS, type Spots } from './spots.js';
import type { TiedBodies } from './tied-bodies.js';

const BLOCK = SIDE * SIDE;
const way = new Float64Array(3);
const slip = new Float64Array(3);
const given = new Float64Array(SIDE);
const momentum = new Float64Array(SIDE);

/**
 * Links and touches one at a time, to and fro: each impulse only takes energy, so this never runs away, and what it leaves
 * open is made good in the steps that follow. For steps in which Newton's search finds no end.
 */
export class RopeSweeps {
  readonly #bodies: TiedBodies;
  readonly #block = new DenseLu();
  #inverses = new Float64Array(0);

  constructor(bodies: TiedBodies) {
    this.#bodies = bodies;
  }

  /** From velocities without pulls on. */
  begin(strands: readonly Links[]): void {
    const { count, inertias, momenta, velocities, joined } = this.#bodies;
    if (this.#inverses.length < BLOCK * count) this.#inverses = new Float64Array(BLOCK * count);
    for (const each of joined) if (each.active) each.begin(velocities);
    for (let b = 0; b < count; b++) {
      const own = this.#bodies.with(b);
      own?.complianceOf(b, this.#inverses, BLOCK * b);
      if (own) continue;
      this.#block.resize(SIDE);
      for (let n = 0; n < BLOCK; n++) this.#block.matrix[n] = inertias[BLOCK * b + n]!;
      momentum.set(momenta.subarray(SIDE * b, SIDE * (b + 1)));
      for (const { strand } of strands) this.#tie(strand, b);
      this.#block.factor();
      this.#block.inverseBlock(0, SIDE, this.#inverses.subarray(BLOCK * b, BLOCK * (b + 1)));
      for (let r = 0; r < SIDE; r++) {
        let v = 0;
        for (let c = 0; c < SIDE; c++)
          v += this.#inverses[BLOCK * b + SIDE * r + c]! * momentum[c]!;
        velocities[SIDE * b + r] = v;
      }
    }
  }

  /** Points that are tied to a body weigh with it, where they are, and bring what they have. */
  #tie(strand: Strand, b: number): void {
    const { holders, masses, free, points } = strand;
    const { matrix } = this.#block;
    for (let i = 0; i < points; i++) {
      if (holders[i] !== b) continue;
      for (let k = 0; k < 3; k++) {
        way.fill(0);
        way[k] = 1;
        this.#turn(strand, i, 1);
        for (let r = 0; r < SIDE; r++) {
          momentum[r]! += masses[i]! * free[3 * i + k]! * given[r]!;
          for (let c = 0; c < SIDE; c++)
            matrix[SIDE * r + c]! += masses[i]! * given[r]! * given[c]!;
        }
      }
    }
  }

  solve(strands: readonly Links[], dt: number): void {
    for (const { strand } of strands) {
      strand.pulls.fill(0);
      for (const { presses, rubs } of [strand.knots, strand.between]) {
        presses.fill(0);
        rubs.fill(0);
      }
    }
    for (let sweep = 0; sweep < ROPE_SWEEPS; sweep++)
      for (const links of strands) this.#sweep(links, dt, sweep % 2 === 1);
    for (const { strand } of strands)
      for (let i = 0; i < strand.points; i++) if (strand.holders[i]! >= 0) this.#follow(strand, i);
  }

  #sweep(links: Links, dt: number, back: boolean): void {
    const { strand } = links;
    const { points, knots, between } = strand;
    for (let n = 0; n < points; n++) {
      const i = back ? points - 1 - n : n;
      if (i < points - 1) this.#link(links, i, dt);
      if (knots.touches[i]) this.#touch(strand, knots, i, dt);
      for (let c = SPOTS * i; c < SPOTS * (i + 1) && c < between.count; c++)
        if (between.touches[c]) this.#touch(strand, between, c, dt);
    }
  }

  /** A link that would be too long. */
  #link({ strand, limits }: Links, i: number, dt: number): void {
    const { ways, pulls, found } = strand;
    this.#follow(strand, i);
    this.#follow(strand, i + 1);
    let square = 0;
    for (let k = 0; k < 3; k++) {
      const j = 3 * i + k;
      way[k] = ways[j]! + dt * (found[j + 3]! - found[j]!);
      square += way[k]! ** 2;
    }
    const length = Math.sqrt(square);
    const over = length - limits[i]!;
    if (!(over > 0)) return;
    for (let k = 0; k < 3; k++) way[k]! /= length;
    const gives = this.#softness(strand, i) + this.#softness(strand, i + 1);
    if (!(gives > 0)) return;
    const impulse = over / (dt * gives);
    pulls[i]! += impulse / length;
    this.#push(strand, i, impulse);
    this.#push(strand, i + 1, -impulse);
  }

  /** What 1 N s along `way` does to the speed of a point along it. */
  #softness(strand: Strand, i: number): number {
    const holder = strand.holders[i]!;
    if (holder === HELD) return 0;
    if (holder < HELD) return 1 / strand.masses[i]!;
    this.#turn(strand, i, 1);
    let sum = 0;
    for (let r = 0; r < SIDE; r++)
      for (let c = 0; c < SIDE; c++)
        sum += given[r]! * this.#inverses[BLOCK * holder + SIDE * r + c]! * given[c]!;
    return sum;
  }

  /** An impulse along `way` as the body of a tied point has it. */
  #turn({ arms }: Strand, i: number, impulse: number): void {
    const x = arms[3 * i]!;
    const y = arms[3 * i + 1]!;
    const z = arms[3 * i + 2]!;
    for (let k = 0; k < 3; k++) given[k] = impulse * way[k]!;
    given[3] = y * given[2]! - z * given[1]!;
    given[4] = z * given[0]! - x * given[2]!;
    given[5] = x * given[1]! - y * given[0]!;
  }

  #push(strand: Strand, i: number, impulse: number): void {
    const { holders, masses, found } = strand;
    const holder = holders[i]!;
    if (holder === HELD) return;
    if (holder < HELD) {
      for (let k = 0; k < 3; k++) found[3 * i + k]! += (impulse * way[k]!) / masses[i]!;
      return;
    }
    this.#turn(strand, i, impulse);
    const joined = this.#bodies.with(holder);
    if (joined) joined.push(holder, given, this.#bodies.velocities);
    else this.#pushBody(holder);
  }

  #pushBody(holder: number): void {
    const { velocities } = this.#bodies;
    for (let r = 0; r < SIDE; r++)
      for (let c = 0; c < SIDE; c++)
        velocities[SIDE * holder + r]! +=
          this.#inverses[BLOCK * holder + SIDE * r + c]! * given[c]!;
  }

  /** A tied point goes where its body takes it. */
  #follow({ holders, arms, found }: Strand, i: number): void {
    if (holders[i]! < 0) return;
    const v = this.#bodies.velocities;
    const b = SIDE * holders[i]!;
    const j = 3 * i;
    found[j] = v[b]! + v[b + 4]! * arms[j + 2]! - v[b + 5]! * arms[j + 1]!;
    found[j + 1] = v[b + 1]! + v[b + 5]! * arms[j]! - v[b + 3]! * arms[j + 2]!;
    found[j + 2] = v[b + 2]! + v[b + 3]! * arms[j + 1]! - v[b + 4]! * arms[j]!;
  }

  /** Pushed out, and rubbed by as much of that as Coulomb's law allows. */
  #touch(strand: Strand, spots: Spots, c: number, dt: number): void {
    const { firsts, shares, normals, gaps, surfaces, presses, rubs, frictions } = spots;
    const { found } = strand;
    const i = firsts[c]!;
    const share = shares[c]!;
    const next = share > 0 ? i + 1 : i;
    const j = 3 * c;
    this.#follow(strand, i);
    this.#follow(strand, next);
    let away = 0;
    for (let k = 0; k < 3; k++) {
      const v = found[3 * i + k]!;
      slip[k] = v + share * (found[3 * next + k]! - v) - surfaces[j + k]!;
      away += normals[j + k]! * slip[k]!;
    }
    for (let k = 0; k < 3; k++) way[k] = normals[j + k]!;
    const out = this.#answer(strand, i, share, Math.max(0, -gaps[c]! / dt - away));
    presses[c]! += out;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      slip[k]! -= away * normals[j + k]!;
      square += slip[k]! ** 2;
    }
    if (!(square > 0)) return;
    const speed = Math.sqrt(square);
    for (let k = 0; k < 3; k++) way[k] = -slip[k]! / speed;
    const rub = this.#answer(strand, i, share, speed, frictions[c]! * out);
    for (let k = 0; k < 3; k++) rubs[j + k]! += rub * way[k]!;
  }

  /** A spot is given such a speed along `way`, by no more than such an impulse, N s: which is answered. */
  #answer(strand: Strand, i: number, share: number, speed: number, most = Infinity): number {
    let gives = (1 - share) ** 2 * this.#softness(strand, i);
    if (share > 0) gives += share ** 2 * this.#softness(strand, i + 1);
    const impulse = gives > 0 ? Math.min(most, speed / gives) : 0;
    if (!(impulse > 0)) return 0;
    this.#push(strand, i, (1 - share) * impulse);
    if (share > 0) this.#push(strand, i + 1, share * impulse);
    return impulse;
  }
}
