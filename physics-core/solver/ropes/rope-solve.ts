import { dot3, writeTurn } from '../../base/flat-math.js';
import { SIDE } from '../joints/blocks.js';
import { DenseLu } from '../matrix/dense-lu.js';
import {
  COIL_MISS,
  COIL_TRIES,
  ROPE_GAIN,
  ROPE_FLUNG,
  ROPE_MISS,
  ROPE_ROUNDS,
  ROPE_ROUNDS_AGAIN,
  ROPE_ROUNDS_NEAREST,
} from '../tolerances.js';
import { sweepCoils } from './coil-sweeps.js';
import { Elimination } from './elimination.js';
import type { JoinedBodies } from './joined-bodies.js';
import { Links, EVEN, NEAREST, type Directions } from './links.js';
import { HELD, type Strand } from './strand.js';
import { RopeSweeps } from './rope-sweeps.js';
import { TiedBodies } from './tied-bodies.js';
import { Touches } from './touches.js';

const BLOCK = SIDE * SIDE;

/** A strand, and what a step makes of it. */
class Part {
  readonly strand: Strand;
  readonly links: Links;
  /** Of its points, and of its links between them. */
  readonly knots: Touches;
  readonly between: Touches;
  readonly elimination: Elimination;
  /** Ends of its stretches: points that are held or tied, and its own ends. */
  readonly stops: number[] = [];
  readonly pullsBefore: Float64Array;

  constructor(strand: Strand) {
    this.strand = strand;
    this.links = new Links(strand);
    this.knots = new Touches(strand, strand.knots);
    this.between = new Touches(strand, strand.between);
    this.elimination = new Elimination(strand, this.links, this.knots, this.between);
    this.pullsBefore = new Float64Array(strand.points - 1);
  }

  divide(): void {
    const { holders, points } = this.strand;
    this.stops.length = 0;
    for (let i = 0; i < points; i++)
      if (i === 0 || i === points - 1 || holders[i]! >= HELD) this.stops.push(i);
  }
}

const spin = new Float64Array(3);
const turn = new Float64Array(4);
const acting = new Float64Array(3);
const crossed = new Float64Array(3 * SIDE);
const missing = new Float64Array(3);
const own = new Float64Array(9);

/**
 * Ropes that hang together by the bodies they are tied to, solved at once: all points, all pulls and all bodies are
 * unknowns of one search by Newton's method. Along each rope they are eliminated one after the other; what is left are
 * the bodies.
 */
export class RopeSolve {
  readonly bodies = new TiedBodies();
  readonly #parts: Part[] = [];
  /** Those that may meet themselves in this step. */
  readonly #meets: Part[] = [];
  #links: Links[] = [];
  readonly #sweeps = new RopeSweeps(this.bodies);
  readonly #system = new DenseLu();
  readonly #block = new DenseLu();
  #rest = new Float64Array(0);
  #change = new Float64Array(0);
  #velocitiesBefore = new Float64Array(0);
  /** Of each body, a block: what the ropes and all that hangs on them resists its velocity by; and what they give it. */
  resistance = new Float64Array(0);
  impulse = new Float64Array(0);
  /** A turn of a body turns the arms of what is tied to it in this search. */
  #armsTurn = true;
  /** Whether the last step was found with even pulls. */
  even = false;
  /** Rounds of the search so far, and how far the last one may move a point, metres. */
  #rounds = 0;
  #miss = ROPE_MISS;

  take(strands: readonly Strand[], bodies: number, joined: readonly JoinedBodies[] = []): void {
    this.#parts.length = 0;
    for (const strand of strands) this.#parts.push(new Part(strand));
    this.#links = this.#parts.map(({ links }) => links);
    this.bodies.resize(bodies, joined);
    this.#rest = new Float64Array(SIDE * bodies);
    this.#change = new Float64Array(SIDE * bodies);
    this.#velocitiesBefore = new Float64Array(SIDE * bodies);
    this.resistance = new Float64Array(BLOCK * bodies);
    this.impulse = new Float64Array(SIDE * bodies);
  }

  /**
   * Finds the velocities of a step of `dt` seconds. The strands have begun it; their `free` velocities, those of held
   * points, the arms of tied ones and what the bodies would do are known. False: none that make sense.
   */
  solve(dt: number): boolean {
    for (const part of this.#parts) {
      part.divide();
      part.links.begin(dt);
      part.knots.begin(dt);
      part.between.begin(dt);
    }
    this.#beginMeeting(dt);
    this.#keep();
    return this.#findOrSweep(dt) && (this.#meets.length === 0 || this.#meet(dt));
  }

  #beginMeeting(dt: number): void {
    this.#miss = ROPE_MISS;
    this.#meets.length = 0;
    for (const part of this.#parts) {
      const { coils } = part.strand;
      if (!coils?.count) continue;
      this.#meets.push(part);
      if (coils.pressed) this.#miss = COIL_MISS * dt;
      coils.begin(this.bodies.inertias);
    }
  }

  #findOrSweep(dt: number): boolean {
    this.#armsTurn = true;
    if (this.#find(dt)) return true;
    // Arms that turn find ends that others do not; where they find none, a search without them may.
    this.#armsTurn = false;
    return (this.bodies.count > 0 && this.#find(dt)) || this.#sweep(dt);
  }

  /**
   * What was found goes by what the last step knew of where ropes meet themselves. What is missing of that is found one place
   * after the other, and what all else says to that by another search, until both agree. What bodies say has the last word: they
   * have no part in what is found place by place.
   */
  #meet(dt: number): boolean {
    const meets = this.#meets;
    for (let tries = 0; tries <= COIL_TRIES; tries++) {
      let most = 0;
      for (const { strand, links } of meets)
        most = Math.max(most, sweepCoils(links, strand.coils!, dt));
      const last = most < COIL_MISS * dt || tries === COIL_TRIES;
      if (last && this.bodies.count === 0) break;
      for (const { strand } of meets) strand.coils!.give();
      if (!this.#searchAgain(dt)) {
        this.#sweep(dt);
        tries = Math.max(tries, COIL_TRIES - 1);
      }
      if (last) break;
    }
    for (const { strand } of meets) strand.coils!.end();
    return this.#isFinite();
  }

  /** As far as it was found before, by what gave no energy there. */
  #searchAgain(dt: number): boolean {
    if (this.even && this.#search(dt, EVEN, ROPE_ROUNDS_AGAIN, 2) && !this.#gains()) return true;
    if (this.even) this.#goBack();
    this.even = false;
    return this.#search(dt, NEAREST, ROPE_ROUNDS_AGAIN, 2);
  }

  /** By even pulls, else the nearest places. */
  #find(dt: number): boolean {
    this.even = this.#search(dt, EVEN, ROPE_ROUNDS) && !this.#gains();
    if (this.even) return true;
    this.#goBack();
    if (this.#search(dt, NEAREST, ROPE_ROUNDS_NEAREST)) return true;
    this.#goBack();
    return false;
  }

  /** Finds them anew, where joints have said that bodies go otherwise than they had: from what was found, it is near. */
  solveAgain(dt: number): boolean {
    const meets = this.#meets.length > 0;
    if (this.even && !meets && this.#search(dt, EVEN, ROPE_ROUNDS, 2) && !this.#gains())
      return true;
    return this.solve(dt);
  }

  /** Whether a link is found to push so hard that a point would be elsewhere without: it is let go in the next round. */
  #pushes(dt: number): boolean {
    for (const { strand, links } of this.#parts) {
      const { pulls, lengths, masses, points } = strand;
      for (let i = 0; i < points - 1; i++) {
        const least = (ROPE_MISS * Math.min(masses[i]!, masses[i + 1]!)) / dt;
        if (links.taut[i] && pulls[i]! * lengths[i]! < -least) return true;
      }
    }
    return false;
  }

  /**
   * Whether pulls did work on the points in the step. Those of links that are as long at its end as at the last one's do none;
   * where one goes taut in the midst of a turn even pulls may.
   */
  #gains(): boolean {
    let work = 0;
    let energy = this.#square(this.bodies.velocities);
    for (const { active, energy: theirs } of this.bodies.joined) if (active) energy += theirs;
    for (const { strand, links } of this.#parts) {
      const { found, velocities, pulls, masses, points, softness } = strand;
      const { pulling, taut } = links;
      for (let i = 0; i < points; i++) energy += masses[i]! * dot3(found, 3 * i, found, 3 * i);
      for (let i = 0; i < points - 1; i++) {
        if (!taut[i] || softness[i]! > 0) continue;
        for (let j = 3 * i; j < 3 * i + 3; j++)
          work -=
            pulls[i]! *
            pulling[j]! *
            (found[j + 3]! + velocities[j + 3]! - found[j]! - velocities[j]!);
      }
    }
    return work > ROPE_GAIN * energy;
  }

  /** What never runs away. */
  #sweep(dt: number): boolean {
    this.#goBack();
    this.#sweeps.begin(this.#links);
    this.#sweeps.solve(this.#links, dt);
    for (const { strand } of this.#parts) strand.armsAfter.set(strand.arms);
    this.resistance.fill(0);
    this.#tellImpulses();
    return this.#isFinite();
  }

  #keep(): void {
    const { velocities, count } = this.bodies;
    for (let i = 0; i < SIDE * count; i++) this.#velocitiesBefore[i] = velocities[i]!;
    for (const { strand, pullsBefore } of this.#parts) {
      const { holders, found, velocities: before, points } = strand;
      pullsBefore.set(strand.pulls);
      for (let i = 0; i < 3 * points; i++)
        if (holders[Math.floor(i / 3)]! < HELD) found[i] = before[i]!;
    }
  }

  #goBack(): void {
    const { velocities, count } = this.bodies;
    for (let i = 0; i < SIDE * count; i++) velocities[i] = this.#velocitiesBefore[i]!;
    for (const { strand, pullsBefore } of this.#parts) {
      const { holders, found, free, points } = strand;
      strand.pulls.set(pullsBefore);
      for (let i = 0; i < 3 * points; i++)
        if (holders[Math.floor(i / 3)]! < HELD) found[i] = free[i]!;
    }
  }

  #isFinite(): boolean {
    let sum = 0;
    for (const { strand } of this.#parts) for (const v of strand.found) sum += v;
    return Number.isFinite(sum);
  }

  #search(dt: number, directions: Directions, most: number, first = 1): boolean {
    for (const { knots, between } of this.#parts) knots.cautious = between.cautious = false;
    for (this.#rounds = first; this.#rounds <= most; this.#rounds++) {
      this.#assemble(dt, directions);
      this.#system.factor();
      this.#change.set(this.#rest);
      this.#system.solve(this.#change);
      const step = this.#follow(dt);
      if (!(step < ROPE_FLUNG)) return false;
      if (step < this.#miss && !this.#pushes(dt)) return this.#end(dt);
    }
    return false;
  }

  // ---- a round --------------------------------------------------------------------------------------------------------

  #assemble(dt: number, directions: Directions): void {
    const { count, inertias, momenta, velocities } = this.bodies;
    const size = SIDE * count;
    this.#system.resize(size);
    for (let b = 0; b < count; b++) {
      this.#rest.fill(0, SIDE * b, SIDE * (b + 1));
      if (this.bodies.with(b)) continue;
      for (let r = 0; r < SIDE; r++) {
        let rest = momenta[SIDE * b + r]!;
        for (let c = 0; c < SIDE; c++) {
          const inertia = inertias[BLOCK * b + SIDE * r + c]!;
          this.#system.matrix[(SIDE * b + r) * size + SIDE * b + c] = inertia;
          rest -= inertia * velocities[SIDE * b + c]!;
        }
        this.#rest[SIDE * b + r] = rest;
      }
    }
    for (const part of this.#parts) this.#assemblePart(part, dt, directions);
    for (const each of this.bodies.joined)
      if (each.active) each.assemble(this.#system, this.#rest, velocities);
  }

  #assemblePart(part: Part, dt: number, directions: Directions): void {
    const { strand, links, knots, between, elimination, stops } = part;
    const { holders, masses, free, found } = strand;
    this.#placeTied(part, dt);
    links.read(dt, directions, this.#rounds === 1);
    knots.read(dt, this.#rounds === 1);
    between.read(dt, this.#rounds === 1);
    elimination.fill(dt);
    for (const i of stops) {
      if (holders[i]! < 0) continue;
      own[0] = own[4] = own[8] = masses[i]!;
      for (let k = 0; k < 3; k++) missing[k] = masses[i]! * (free[3 * i + k]! - found[3 * i + k]!);
      this.#push(strand, i, missing, 0, directions, dt);
      this.#resist(strand, i, i, own, 0, directions);
    }
    for (let n = 1; n < stops.length; n++) {
      const first = stops[n - 1]!;
      const last = stops[n]!;
      elimination.reduce(first, last, dt);
      const { ends, endRests } = elimination;
      const a = holders[first]! >= 0;
      const b = holders[last]! >= 0;
      if (a) this.#push(strand, first, endRests, 0, directions, dt);
      if (b) this.#push(strand, last, endRests, 3, directions, dt);
      if (a) this.#resist(strand, first, first, ends, 0, directions);
      if (a && b) this.#resist(strand, first, last, ends, 9, directions);
      if (a && b) this.#resist(strand, last, first, ends, 18, directions);
      if (b) this.#resist(strand, last, last, ends, 27, directions);
    }
  }

  /** Tied points are where their bodies take them. */
  #placeTied({ strand, stops }: Part, dt: number): void {
    const { holders, arms, armsAfter, found } = strand;
    const { velocities } = this.bodies;
    for (const i of stops) {
      const at = SIDE * holders[i]!;
      if (at < 0) continue;
      for (let k = 0; k < 3; k++) spin[k] = velocities[at + 3 + k]!;
      rotateBy(spin, dt, arms, armsAfter, 3 * i);
      for (let k = 0; k < 3; k++) {
        const j = 3 * i + k;
        found[j] = velocities[at + k]! + (armsAfter[j]! - arms[j]!) / dt;
      }
    }
  }

  /** Where what acts on a tied point has hold of its body, as its link pulls. */
  #findArm(
    { arms, armsBefore, armsAfter }: Strand,
    i: number,
    { after, before }: Directions,
  ): void {
    for (let k = 0; k < 3; k++) {
      const j = 3 * i + k;
      acting[k] =
        arms[j]! + after * (armsAfter[j]! - arms[j]!) - before * (arms[j]! - armsBefore[j]!);
    }
  }

  /** An impulse on a tied point acts on its body. */
  #push(
    strand: Strand,
    i: number,
    p: Float64Array,
    at: number,
    directions: Directions,
    dt: number,
  ): void {
    const rest = this.#rest;
    const b = SIDE * strand.holders[i]!;
    const x = p[at]!;
    const y = p[at + 1]!;
    const z = p[at + 2]!;
    this.#findArm(strand, i, directions);
    rest[b]! += x;
    rest[b + 1]! += y;
    rest[b + 2]! += z;
    rest[b + 3]! += acting[1]! * z - acting[2]! * y;
    rest[b + 4]! += acting[2]! * x - acting[0]! * z;
    rest[b + 5]! += acting[0]! * y - acting[1]! * x;
    if (this.#armsTurn) this.#stiffen(strand, i, p, at, directions.after * dt);
  }

  /**
   * A turn of the body turns its arm, too, and an impulse has another moment then. Without that what is light and pulled hard, as
   * a ring between a rope and a load, would find no end: each round would turn it too far.
   */
  #stiffen(
    { armsAfter, holders }: Strand,
    i: number,
    p: Float64Array,
    at: number,
    dt: number,
  ): void {
    const { matrix, size } = this.#system;
    const b = SIDE * holders[i]! + 3;
    const along = dot3(armsAfter, 3 * i, p, at);
    for (let r = 0; r < 3; r++)
      for (let c = 0; c < 3; c++) {
        const turned = (r === c ? along : 0) - armsAfter[3 * i + r]! * p[at + c]!;
        matrix[(b + r) * size + b + c]! += dt * turned;
      }
  }

  /** What a change of the velocity of point `j` does to the momentum of point `i`, as bodies see it. */
  #resist(
    strand: Strand,
    i: number,
    j: number,
    m: Float64Array,
    at: number,
    directions: Directions,
  ): void {
    const { arms, armsAfter, holders } = strand;
    const x = (arms[3 * j]! + armsAfter[3 * j]!) / 2;
    const y = (arms[3 * j + 1]! + armsAfter[3 * j + 1]!) / 2;
    const z = (arms[3 * j + 2]! + armsAfter[3 * j + 2]!) / 2;
    for (let r = 0; r < 3; r++) {
      const row = at + 3 * r;
      const a = m[row]!;
      const b = m[row + 1]!;
      const c = m[row + 2]!;
      const to = SIDE * r;
      crossed[to] = a;
      crossed[to + 1] = b;
      crossed[to + 2] = c;
      crossed[to + 3] = c * y - b * z;
      crossed[to + 4] = a * z - c * x;
      crossed[to + 5] = b * x - a * y;
    }
    this.#findArm(strand, i, directions);
    const { matrix, size } = this.#system;
    const from = SIDE * holders[i]! * size + SIDE * holders[j]!;
    const u = acting[0]!;
    const v = acting[1]!;
    const w = acting[2]!;
    for (let c = 0; c < SIDE; c++) {
      const fx = crossed[c]!;
      const fy = crossed[SIDE + c]!;
      const fz = crossed[2 * SIDE + c]!;
      matrix[from + c]! += fx;
      matrix[from + size + c]! += fy;
      matrix[from + 2 * size + c]! += fz;
      matrix[from + 3 * size + c]! += v * fz - w * fy;
      matrix[from + 4 * size + c]! += w * fx - u * fz;
      matrix[from + 5 * size + c]! += u * fy - v * fx;
    }
  }

  /** All goes on by what was found; returns how far the farthest does, metres. */
  #follow(dt: number): number {
    const { velocities, count } = this.bodies;
    for (const { strand, elimination, stops } of this.#parts) {
      for (const i of stops) this.#changeStop(strand, i, elimination.change);
      for (let n = 1; n < stops.length; n++) elimination.follow(stops[n - 1]!, stops[n]!, dt);
    }
    const share = this.#share(dt);
    for (let i = 0; i < SIDE * count; i++) velocities[i]! += share * this.#change[i]!;
    for (const each of this.bodies.joined) if (each.active) each.follow(this.#change, share);
    let most = 0;
    for (const { strand, links, knots, between, elimination } of this.#parts) {
      const { found, pulls, points } = strand;
      const { change, pullChange } = elimination;
      knots.follow(change, share, dt);
      between.follow(change, share, dt);
      for (let i = 0; i < 3 * points; i++) {
        found[i]! += share * change[i]!;
        const way = Math.abs(change[i]!);
        if (!(way <= most)) most = way;
      }
      for (let i = 0; i < points - 1; i++) if (links.taut[i]) pulls[i]! += share * pullChange[i]!;
    }
    return most * dt;
  }

  /** Where friction turns round a round goes no further, and the next one is cautious. */
  #share(dt: number): number {
    let share = 1;
    for (const { knots, between, elimination } of this.#parts) {
      if (!knots.any && !between.any) continue;
      const inertia = this.#inertia();
      share = Math.min(share, knots.share(elimination.change, inertia, dt));
      share = Math.min(share, between.share(elimination.change, inertia, dt));
    }
    for (const { knots, between } of this.#parts) knots.cautious = between.cautious = share < 1;
    return share;
  }

  /** Of velocities of the bodies by themselves: twice their energy. */
  #square(v: Float64Array): number {
    const { inertias, count } = this.bodies;
    let sum = 0;
    for (let b = 0; b < count; b++)
      for (let r = 0; r < SIDE; r++)
        for (let c = 0; c < SIDE; c++)
          sum += v[SIDE * b + r]! * inertias[BLOCK * b + SIDE * r + c]! * v[SIDE * b + c]!;
    return sum;
  }

  /** Of the change that was found: twice its energy. */
  #inertia(): number {
    let sum = this.#square(this.#change);
    for (const { strand, elimination } of this.#parts)
      for (let i = 0; i < strand.points; i++)
        sum += strand.masses[i]! * dot3(elimination.change, 3 * i, elimination.change, 3 * i);
    return sum;
  }

  #changeStop({ holders, arms, armsAfter }: Strand, i: number, change: Float64Array): void {
    const j = 3 * i;
    const holder = holders[i]!;
    if (holder < HELD) return;
    change[j] = change[j + 1] = change[j + 2] = 0;
    if (holder < 0) return;
    const d = this.#change;
    const b = SIDE * holder;
    const x = (arms[j]! + armsAfter[j]!) / 2;
    const y = (arms[j + 1]! + armsAfter[j + 1]!) / 2;
    const z = (arms[j + 2]! + armsAfter[j + 2]!) / 2;
    change[j] = d[b]! + d[b + 4]! * z - d[b + 5]! * y;
    change[j + 1] = d[b + 1]! + d[b + 5]! * x - d[b + 3]! * z;
    change[j + 2] = d[b + 2]! + d[b + 3]! * y - d[b + 4]! * x;
  }

  /** What there is to know of what was found. */
  #end(dt: number): boolean {
    for (const part of this.#parts) this.#placeTied(part, dt);
    const { count, inertias } = this.bodies;
    const block = this.#block;
    for (let b = 0; b < count; b++) {
      if (this.bodies.with(b)) continue;
      block.resize(SIDE);
      this.#system.inverseBlock(SIDE * b, SIDE, block.matrix);
      block.factor();
      const resistance = this.resistance.subarray(BLOCK * b, BLOCK * (b + 1));
      block.inverseBlock(0, SIDE, resistance);
      for (let n = 0; n < BLOCK; n++) resistance[n]! -= inertias[BLOCK * b + n]!;
    }
    for (const each of this.bodies.joined)
      if (each.active) each.tellResistance(this.#system, this.resistance);
    this.#tellImpulses();
    return true;
  }

  /** Nothing was found that makes sense: ropes do nothing in this step. */
  forget(): void {
    this.bodies.velocities.fill(0);
    this.resistance.fill(0);
    this.impulse.fill(0);
  }

  #tellImpulses(): void {
    const { count, inertias, momenta, velocities, joined } = this.bodies;
    for (const { active, from, impulse } of joined) if (active) this.impulse.set(impulse, from);
    for (let b = 0; b < count; b++) {
      if (this.bodies.with(b)) continue;
      for (let r = 0; r < SIDE; r++) {
        let impulse = -momenta[SIDE * b + r]!;
        for (let c = 0; c < SIDE; c++)
          impulse += inertias[BLOCK * b + SIDE * r + c]! * velocities[SIDE * b + c]!;
        this.impulse[SIDE * b + r] = impulse;
      }
    }
  }
}

/** A vector at `j`, turned by a spin in such a time. */
function rotateBy(
  by: Float64Array,
  dt: number,
  from: Float64Array,
  to: Float64Array,
  j: number,
): void {
  writeTurn(turn, by, dt);
  const x = from[j]!;
  const y = from[j + 1]!;
  const z = from[j + 2]!;
  const qx = turn[0]!;
  const qy = turn[1]!;
  const qz = turn[2]!;
  const qw = turn[3]!;
  const u = 2 * (qy * z - qz * y);
  const v = 2 * (qz * x - qx * z);
  const w = 2 * (qx * y - qy * x);
  to[j] = x + qw * u + (qy * w - qz * v);
  to[j + 1] = y + qw * v + (qz * u - qx * w);
  to[j + 2] = z + qw * w + (qx * v - qy * u);
}
