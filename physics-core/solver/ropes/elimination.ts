import { dot3 } from '../../base/flat-math.js';
import type { Links } from './links.js';
import { SPOTS } from './spots.js';
import { HELD, type Strand } from './strand.js';
import type { Touches } from './touches.js';

const TURN = 9;

/** Of a 3 × 3 matrix; `to` may be `from`. */
export function invert3(from: Float64Array, at: number, to: Float64Array, into: number): void {
  const a = from[at]!;
  const b = from[at + 1]!;
  const c = from[at + 2]!;
  const d = from[at + 3]!;
  const e = from[at + 4]!;
  const f = from[at + 5]!;
  const g = from[at + 6]!;
  const h = from[at + 7]!;
  const i = from[at + 8]!;
  const x = e * i - f * h;
  const y = f * g - d * i;
  const z = d * h - e * g;
  const t = 1 / (a * x + b * y + c * z);
  to[into] = x * t;
  to[into + 1] = (c * h - b * i) * t;
  to[into + 2] = (b * f - c * e) * t;
  to[into + 3] = y * t;
  to[into + 4] = (a * i - c * g) * t;
  to[into + 5] = (c * d - a * f) * t;
  to[into + 6] = z * t;
  to[into + 7] = (b * g - a * h) * t;
  to[into + 8] = (a * e - b * d) * t;
}

/** out = m v */
function times(out: Float64Array, m: Float64Array, at: number, v: Float64Array, j: number): void {
  const x = v[j]!;
  const y = v[j + 1]!;
  const z = v[j + 2]!;
  out[0] = m[at]! * x + m[at + 1]! * y + m[at + 2]! * z;
  out[1] = m[at + 3]! * x + m[at + 4]! * y + m[at + 5]! * z;
  out[2] = m[at + 6]! * x + m[at + 7]! * y + m[at + 8]! * z;
}

/** out = mᵀ v */
function timesT(out: Float64Array, m: Float64Array, at: number, v: Float64Array, j: number): void {
  const x = v[j]!;
  const y = v[j + 1]!;
  const z = v[j + 2]!;
  out[0] = m[at]! * x + m[at + 3]! * y + m[at + 6]! * z;
  out[1] = m[at + 1]! * x + m[at + 4]! * y + m[at + 7]! * z;
  out[2] = m[at + 2]! * x + m[at + 5]! * y + m[at + 8]! * z;
}

const D = new Float64Array(3);
const R = new Float64Array(3);
const E = new Float64Array(3);
const B = new Float64Array(3);
const T = new Float64Array(3);
const F = new Float64Array(3);
/** How the first end acts on a point, by its inverse; and how it is acted on. */
const from = new Float64Array(TURN);
const to = new Float64Array(TURN);
/** How the points of a link resist one by the other; and that by the inverse of the first. */
const M = new Float64Array(TURN);
const N = new Float64Array(TURN);
const I = new Float64Array(TURN);

/** out = m n, of 3 × 3 each. */
function multiply(
  out: Float64Array,
  m: Float64Array,
  i: number,
  n: Float64Array,
  j: number,
  o = 0,
): void {
  for (let r = 0; r < 3; r++)
    for (let c = 0; c < 3; c++)
      out[o + 3 * r + c] =
        m[i + 3 * r]! * n[j + c]! +
        m[i + 3 * r + 1]! * n[j + 3 + c]! +
        m[i + 3 * r + 2]! * n[j + 6 + c]!;
}

/**
 * One round of Newton for a stretch of a strand between two points that are held or tied, or its free ends. Its points and
 * pulls are eliminated from its first end to its last: what is left are equations of the ends alone, as if the stretch were
 * one stiff element between them.
 */
export class Elimination {
  readonly #strand: Strand;
  readonly #links: Links;
  readonly #knots: Touches;
  readonly #between: Touches;
  /** Of each link, how touches between its points resist one by the other; 1: there are any. */
  readonly #couples: Float64Array;
  readonly #coupled: Uint8Array;
  /** Of each point: its block, inverted once it is eliminated, and what is left to be done. */
  readonly #blocks: Float64Array;
  readonly rest: Float64Array;
  /** Of each link: what its pull answers by, what it begins with, and what the second point adds. */
  readonly #answers: Float64Array;
  readonly #starts: Float64Array;
  readonly #adds: Float64Array;
  /** How the first end, where it is tied, stands in the equations of points and pulls, and they in its own. */
  readonly #columns: Float64Array;
  readonly #pullColumns: Float64Array;
  readonly #row = new Float64Array(TURN);
  /** The first end is one that others move, and its link is taut. */
  #sprung = false;
  /** Of the ends: first by first, first by last, last by first, last by last; and what is left of each. */
  readonly ends = new Float64Array(4 * TURN);
  readonly endRests = new Float64Array(6);
  /** What comes of it: changes of velocities and of pulls. */
  readonly change: Float64Array;
  readonly pullChange: Float64Array;

  constructor(strand: Strand, links: Links, knots: Touches, between: Touches) {
    const { points } = strand;
    this.#strand = strand;
    this.#links = links;
    this.#knots = knots;
    this.#between = between;
    this.#couples = new Float64Array(TURN * (points - 1));
    this.#coupled = new Uint8Array(points - 1);
    this.#blocks = new Float64Array(TURN * points);
    this.rest = new Float64Array(3 * points);
    this.#answers = new Float64Array(points - 1);
    this.#starts = new Float64Array(points - 1);
    this.#adds = new Float64Array(3 * points - 3);
    this.#columns = new Float64Array(TURN * points);
    this.#pullColumns = new Float64Array(3 * points - 3);
    this.change = new Float64Array(3 * points);
    this.pullChange = new Float64Array(points - 1);
  }

  /** What is missing of the momentum of each point, without those that others hold, and what resists a change of it. */
  fill(dt: number): void {
    const { masses, free, found, pulls, holders, points } = this.#strand;
    const { stiffness, pulling, taut } = this.#links;
    const blocks = this.#blocks;
    const rest = this.rest;
    for (let i = 0, j = 0; i < points; i++, j += 3) {
      const own = holders[i]! < HELD ? masses[i]! : 0;
      const before = i > 0 && taut[i - 1] ? i - 1 : -1;
      const after = i < points - 1 && taut[i] ? i : -1;
      for (let k = 0; k < 3; k++) {
        let r = own * (free[j + k]! - found[j + k]!);
        if (after >= 0) r += pulls[after]! * pulling[3 * after + k]!;
        if (before >= 0) r -= pulls[before]! * pulling[3 * before + k]!;
        rest[j + k] = r;
      }
      blocks.fill(0, TURN * i, TURN * i + TURN);
      const stiff = (before >= 0 ? stiffness[before]! : 0) + (after >= 0 ? stiffness[after]! : 0);
      for (let k = 0; k < TURN; k += 4) blocks[TURN * i + k] = own + stiff;
      if (this.#knots.acts(i)) {
        this.#knots.press(i, 1, rest, j);
        this.#knots.resist(i, 1, blocks, TURN * i, dt);
      }
    }
    this.#coupled.fill(0);
    if (this.#between.any) this.#couple(dt);
  }

  /** What touches a link between its points couples them. */
  #couple(dt: number): void {
    const between = this.#between;
    const { count, firsts, shares } = between.spots;
    const { holders } = this.#strand;
    const couples = this.#couples.fill(0);
    for (let c = 0; c < count; c++) {
      if (!between.acts(c)) continue;
      const i = firsts[c]!;
      const share = shares[c]!;
      this.#coupled[i] = 1;
      between.resist(c, share * (1 - share), couples, TURN * i, dt);
      if (holders[i]! < HELD)
        this.#touch(c, 1 - share, this.rest, 3 * i, this.#blocks, TURN * i, dt);
      if (holders[i + 1]! < HELD)
        this.#touch(c, share, this.rest, 3 * i + 3, this.#blocks, TURN * (i + 1), dt);
    }
  }

  /** What a touch does to one of its points, as much as that has a share of it. */
  #touch(
    c: number,
    share: number,
    rest: Float64Array,
    at: number,
    blocks: Float64Array,
    block: number,
    dt: number,
  ): void {
    this.#between.press(c, share, rest, at);
    this.#between.resist(c, share * share, blocks, block, dt);
  }

  /** Ends that others move have what touches their own links, as they have what pulls at them. */
  #touchEnds(first: number, last: number, dt: number): void {
    const { shares } = this.#between.spots;
    if (this.#coupled[first] && this.#strand.holders[first]! >= 0)
      for (let c = SPOTS * first; c < SPOTS * (first + 1); c++)
        if (this.#between.acts(c))
          this.#touch(c, 1 - shares[c]!, this.endRests, 0, this.ends, 0, dt);
    if (this.#coupled[last - 1] && this.#strand.holders[last]! >= 0)
      for (let c = SPOTS * (last - 1); c < SPOTS * last; c++)
        if (this.#between.acts(c))
          this.#touch(c, shares[c]!, this.rest, 3 * last, this.#blocks, TURN * last, dt);
  }

  /** How the points of a link resist one by the other: by its pull along itself, and by what touches it between them. */
  #readBetween(i: number): void {
    const k = this.#links.stiffness[i]!;
    for (let n = 0; n < TURN; n++)
      M[n] = (n % 4 === 0 ? k : 0) - (this.#coupled[i] ? this.#couples[TURN * i + n]! : 0);
  }

  /**
   * What is left of the ends of a stretch. A tied point between two stretches has part of its block from either: the first
   * keeps what its own link adds.
   */
  reduce(first: number, last: number, dt: number): void {
    const { holders } = this.#strand;
    const { taut, stiffness, pulling } = this.#links;
    const blocks = this.#blocks;
    const tied = holders[first]! >= 0;
    this.ends.fill(0);
    this.endRests.fill(0);
    this.#row.fill(0);
    this.#columns.fill(0, TURN * first, TURN * (last + 1));
    for (const end of [first, last])
      if (holders[end]! >= HELD) {
        blocks.fill(0, TURN * end, TURN * end + TURN);
        this.rest.fill(0, 3 * end, 3 * end + 3);
      }
    if (tied && taut[first]) {
      const { pulls } = this.#strand;
      for (let k = 0; k < 3; k++) {
        this.ends[4 * k] = stiffness[first]!;
        this.endRests[k] = pulls[first]! * pulling[3 * first + k]!;
      }
    }
    if (holders[last]! >= 0 && taut[last - 1]) {
      const { pulls } = this.#strand;
      for (let k = 0; k < 3; k++) {
        blocks[TURN * last + 4 * k] = stiffness[last - 1]!;
        this.rest[3 * last + k] = -pulls[last - 1]! * pulling[3 * last - 3 + k]!;
      }
    }
    this.#touchEnds(first, last, dt);
    this.#sprung = holders[first]! >= HELD && taut[first] === 1;
    if (tied && !this.#sprung && this.#coupled[first])
      for (let n = 0; n < TURN; n++)
        this.#row[n] = this.#columns[TURN * (first + 1) + n] = this.#couples[TURN * first + n]!;
    for (let i = first; i < last; i++)
      if (i > first || holders[i]! < HELD) this.#eliminate(i, first, tied, dt);
      else if (this.#sprung && last === first + 1 && holders[last]! >= HELD)
        this.#tieEnds(i, tied, dt);
    this.#close(first, last, tied, dt);
  }

  /** One link between two points that others move: a spring, as stiff as it gives way. */
  #tieEnds(i: number, tied: boolean, dt: number): void {
    const { pulling, units, excess, compliance } = this.#links;
    const blocks = this.#blocks;
    const j = 3 * i;
    const next = TURN * (i + 1);
    this.#readBetween(i);
    const answer = (this.#answers[i] = compliance[i]!);
    const start = (this.#starts[i] = excess[i]!);
    for (let r = 0; r < 3; r++) {
      const pull = pulling[j + r]!;
      this.#adds[j + r] = dt * units[j + r]!;
      this.#pullColumns[j + r] = -dt * units[j + r]!;
      this.rest[j + 3 + r]! -= (pull * start) / answer;
      this.endRests[r]! += (pull * start) / answer;
      for (let c = 0; c < 3; c++) {
        const own = (pull * dt * units[j + c]!) / answer;
        const stiff = own + M[3 * r + c]!;
        blocks[next + 3 * r + c]! += own;
        if (!tied) continue;
        this.ends[3 * r + c]! += own;
        this.#row[3 * r + c] = -stiff;
        this.#columns[next + 3 * r + c] = -stiff;
      }
    }
  }

  #eliminate(i: number, first: number, tied: boolean, dt: number): void {
    const { taut, pulling, units, excess, compliance, stiffness } = this.#links;
    const blocks = this.#blocks;
    const rest = this.rest;
    const at = TURN * i;
    const next = at + TURN;
    const j = 3 * i;
    this.#solvePoint(i, first, tied, dt);
    if (this.#coupled[i]) {
      this.#eliminateCoupled(i, tied, dt);
      return;
    }
    if (!taut[i]) {
      this.#row.fill(0);
      return;
    }
    const k = stiffness[i]!;
    times(D, blocks, at, pulling, j);
    timesT(E, blocks, at, units, j);
    const answer = (this.#answers[i] =
      dt * (units[j]! * D[0]! + units[j + 1]! * D[1]! + units[j + 2]! * D[2]!) + compliance[i]!);
    const start = (this.#starts[i] =
      excess[i]! - dt * (units[j]! * R[0]! + units[j + 1]! * R[1]! + units[j + 2]! * R[2]!));
    for (let r = 0; r < 3; r++) {
      this.#adds[j + r] = dt * (units[j + r]! - k * E[r]!);
      B[r] = pulling[j + r]! - k * D[r]!;
    }
    if (tied) {
      for (let n = 0; n < TURN; n++) {
        this.#row[n] = k * to[n]!;
        this.#columns[next + n] = k * from[n]!;
      }
      this.#carryEnd(i, dt);
    }
    for (let r = 0; r < 3; r++) {
      const share = B[r]! / answer;
      rest[j + 3 + r]! += k * R[r]! - share * start;
      for (let c = 0; c < 3; c++)
        blocks[next + 3 * r + c]! += share * this.#adds[j + c]! - k * k * blocks[at + 3 * r + c]!;
    }
  }

  /** The same where something touches the link between the point and the next one: taut or not, it couples them. */
  #eliminateCoupled(i: number, tied: boolean, dt: number): void {
    const blocks = this.#blocks;
    const rest = this.rest;
    const at = TURN * i;
    const next = at + TURN;
    const j = 3 * i;
    this.#readBetween(i);
    multiply(N, blocks, at, M, 0);
    if (tied) {
      multiply(this.#row, to, 0, M, 0);
      multiply(this.#columns, M, 0, from, 0, next);
    }
    times(B, M, 0, R, 0);
    for (let r = 0; r < 3; r++) rest[j + 3 + r]! += B[r]!;
    multiply(I, M, 0, N, 0);
    for (let n = 0; n < TURN; n++) blocks[next + n]! -= I[n]!;
    if (this.#links.taut[i]) this.#pullCoupled(i, tied, dt);
  }

  #pullCoupled(i: number, tied: boolean, dt: number): void {
    const { pulling, units, excess, compliance } = this.#links;
    const blocks = this.#blocks;
    const at = TURN * i;
    const j = 3 * i;
    times(D, blocks, at, pulling, j);
    timesT(E, N, 0, units, j);
    const answer = (this.#answers[i] = dt * dot3(units, j, D, 0) + compliance[i]!);
    const start = (this.#starts[i] = excess[i]! - dt * dot3(units, j, R, 0));
    times(B, M, 0, D, 0);
    for (let r = 0; r < 3; r++) {
      this.#adds[j + r] = dt * (units[j + r]! - E[r]!);
      B[r] = pulling[j + r]! - B[r]!;
    }
    if (tied) this.#carryEnd(i, dt);
    for (let r = 0; r < 3; r++) {
      const share = B[r]! / answer;
      this.rest[j + 3 + r]! -= share * start;
      for (let c = 0; c < 3; c++) blocks[at + TURN + 3 * r + c]! += share * this.#adds[j + c]!;
    }
  }

  /**
   * Inverts the block of a point, and leaves in R what is left of it, and in `from` and `to` how the first end acts on it and
   * is acted on. The one beside a first end that others move is eliminated before the pull between them, which gives way by
   * next to nothing: the other way round all digits would be lost (Sherman and Morrison's formula).
   */
  #solvePoint(i: number, first: number, tied: boolean, dt: number): void {
    const blocks = this.#blocks;
    const at = TURN * i;
    invert3(blocks, at, blocks, at);
    times(R, blocks, at, this.rest, 3 * i);
    if (this.#sprung && i === first + 1) this.#springPoint(first, tied, dt);
    else if (tied) this.#letEnd(at);
  }

  /** The same beside a first end: `I` is the inverse so far, and goes to the block of that end, which has none. */
  #springPoint(first: number, tied: boolean, dt: number): void {
    const { pulling, units, excess, compliance } = this.#links;
    const blocks = this.#blocks;
    const at = TURN * (first + 1);
    const own = TURN * first;
    const j = 3 * first;
    this.#readBetween(first);
    for (let n = 0; n < TURN; n++) blocks[own + n] = blocks[at + n]!;
    times(F, blocks, at, pulling, j);
    timesT(T, blocks, at, units, j);
    let answer = compliance[first]!;
    let start = excess[first]!;
    for (let r = 0; r < 3; r++) {
      answer += dt * units[j + r]! * F[r]!;
      start += dt * units[j + r]! * R[r]!;
    }
    this.#answers[first] = answer;
    const pull = start / answer;
    const share = dt / answer;
    for (let r = 0; r < 3; r++) {
      R[r]! -= F[r]! * pull;
      for (let c = 0; c < 3; c++) blocks[at + 3 * r + c]! -= share * F[r]! * T[c]!;
    }
    if (!tied) return;
    times(D, M, 0, R, 0);
    multiply(from, blocks, at, M, 0);
    multiply(to, M, 0, blocks, at);
    multiply(N, M, 0, from, 0);
    times(E, M, 0, T, 0);
    times(B, M, 0, F, 0);
    for (let r = 0; r < 3; r++) {
      const pulls = pulling[j + r]!;
      this.endRests[r]! += D[r]! + pulls * pull;
      for (let c = 0; c < 3; c++) {
        const n = 3 * r + c;
        const unit = units[j + c]!;
        this.ends[n]! += share * (pulls * (unit - E[c]!) - B[r]! * unit) - N[n]!;
        from[n] = -from[n]! - share * F[r]! * unit;
        to[n] = -to[n]! - share * pulls * T[c]!;
        this.#columns[at + n] = 0;
      }
    }
  }

  /** A point is eliminated that the first end acts on by those before it. */
  #letEnd(at: number): void {
    const columns = this.#columns;
    const row = this.#row;
    multiply(from, this.#blocks, at, columns, at);
    multiply(to, row, 0, this.#blocks, at);
    for (let r = 0; r < 3; r++)
      for (let n = 0; n < 3; n++) {
        const z = row[3 * r + n]!;
        this.endRests[r]! -= z * R[n]!;
        for (let c = 0; c < 3; c++) this.ends[3 * r + c]! -= z * from[3 * n + c]!;
      }
  }

  /** What the first end and those after the link have to do with each other through it. */
  #carryEnd(i: number, dt: number): void {
    const next = TURN * (i + 1);
    const j = 3 * i;
    const { units, pulling } = this.#links;
    const answer = this.#answers[i]!;
    for (let c = 0; c < 3; c++) {
      this.#pullColumns[j + c] = T[c] =
        dt * (units[j]! * from[c]! + units[j + 1]! * from[3 + c]! + units[j + 2]! * from[6 + c]!);
      F[c] =
        to[3 * c]! * pulling[j]! +
        to[3 * c + 1]! * pulling[j + 1]! +
        to[3 * c + 2]! * pulling[j + 2]!;
    }
    for (let r = 0; r < 3; r++) {
      const share = F[r]! / answer;
      this.endRests[r]! -= share * this.#starts[i]!;
      for (let c = 0; c < 3; c++) {
        const n = 3 * r + c;
        this.ends[n]! += share * T[c]!;
        this.#row[n]! += share * this.#adds[j + c]!;
        this.#columns[next + n]! += (B[r]! / answer) * T[c]!;
      }
    }
  }

  /** The last point: free, it is eliminated, too. */
  #close(first: number, last: number, tied: boolean, dt: number): void {
    const { holders } = this.#strand;
    const at = TURN * last;
    if (holders[last]! < HELD) {
      this.#solvePoint(last, first, tied, dt);
      return;
    }
    if (holders[last] === HELD) return;
    for (let n = 0; n < TURN; n++) {
      this.ends[TURN + n] = tied ? this.#row[n]! : 0;
      this.ends[2 * TURN + n] = tied ? this.#columns[at + n]! : 0;
      this.ends[3 * TURN + n] = this.#blocks[at + n]!;
    }
    for (let k = 0; k < 3; k++) this.endRests[3 + k] = this.rest[3 * last + k]!;
  }

  /** The changes of all between, from those of the ends, which stand in `change`. */
  follow(first: number, last: number, dt: number): void {
    const { holders } = this.#strand;
    const { taut } = this.#links;
    const held = holders[first]! >= HELD;
    const tied = holders[first]! >= 0;
    const sprung = held && taut[first] === 1;
    const alone = last === first + 1 && holders[last]! >= HELD;
    for (let i = last; i >= first; i--) {
      if (i < last && !(sprung && i === first && !alone)) this.#followPull(i, first, tied);
      if ((i === last && holders[i]! >= HELD) || (i === first && held)) continue;
      this.#followPoint(i, first, last, tied, sprung && i === first + 1, dt);
    }
  }

  #followPull(i: number, first: number, tied: boolean): void {
    const change = this.change;
    const j = 3 * i;
    if (!this.#links.taut[i]) {
      this.pullChange[i] = 0;
      return;
    }
    let sum = this.#starts[i]!;
    for (let k = 0; k < 3; k++) sum += this.#adds[j + k]! * change[j + 3 + k]!;
    if (tied) for (let k = 0; k < 3; k++) sum += this.#pullColumns[j + k]! * change[3 * first + k]!;
    this.pullChange[i] = sum / this.#answers[i]!;
  }

  #followPoint(
    i: number,
    first: number,
    last: number,
    tied: boolean,
    sprung: boolean,
    dt: number,
  ): void {
    const change = this.change;
    const { pulling, stiffness, taut } = this.#links;
    const pulled = i < last && taut[i] === 1;
    const j = 3 * i;
    for (let k = 0; k < 3; k++) {
      let r = this.rest[j + k]!;
      if (pulled) r += stiffness[i]! * change[j + 3 + k]! + pulling[j + k]! * this.pullChange[i]!;
      if (sprung) r += stiffness[first]! * change[3 * first + k]!;
      else if (tied)
        for (let c = 0; c < 3; c++)
          r -= this.#columns[TURN * i + 3 * k + c]! * change[3 * first + c]!;
      R[k] = r;
    }
    if (i < last && this.#coupled[i]) this.#followTouches(i, i + 1);
    if (sprung && this.#coupled[first]) this.#followTouches(first, first);
    if (sprung) this.#followSpring(first, dt);
    else {
      times(D, this.#blocks, TURN * i, R, 0);
      for (let k = 0; k < 3; k++) change[j + k] = D[k]!;
    }
  }

  /** What touches a link takes from one of its points by how the other one goes on. */
  #followTouches(link: number, other: number): void {
    times(F, this.#couples, TURN * link, this.change, 3 * other);
    for (let k = 0; k < 3; k++) R[k]! -= F[k]!;
  }

  /** The point beside a first end, and the pull between them. */
  #followSpring(first: number, dt: number): void {
    const change = this.change;
    const { pulling, units, excess } = this.#links;
    const j = 3 * first;
    times(D, this.#blocks, TURN * first, R, 0);
    times(F, this.#blocks, TURN * first, pulling, j);
    let sum = excess[first]!;
    for (let k = 0; k < 3; k++) sum += dt * units[j + k]! * (D[k]! - change[j + k]!);
    const pull = (this.pullChange[first] = sum / this.#answers[first]!);
    for (let k = 0; k < 3; k++) change[j + 3 + k] = D[k]! - F[k]! * pull;
  }
}
