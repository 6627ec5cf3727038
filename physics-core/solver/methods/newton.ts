import { hypot } from '../../base/exact/index.js';
import {
  answerTo,
  C,
  OPEN,
  project,
  SLIDES,
  speeds,
  STICKS,
  takePush,
  type ConeContacts,
} from '../rows/cone-contacts.js';
import { clamp, gives, R, rate, takeAlong, type BoundRows } from '../rows/bound-rows.js';
import { energyGuards } from '../energy/energy-guards.js';
import type { Part } from '../part.js';
import { PartMatrix } from './part-matrix.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';
import {
  CREEPING,
  CREEPING_OF_MANY,
  FALL,
  LINE_FLAT,
  LINE_TRIES,
  MANY,
  MISS,
  MISS_OF_MANY,
  MISS_SHARE,
  NEARLY,
  NEWTON_ROUNDS,
  NEWTON_STEPS,
  ROUGH_STILL,
  ROUNDED,
  SHALLOW,
  STILL,
  STILL_SHARE,
  STUCK,
  TO_AND_FRO,
} from '../tolerances.js';

/**
 * Finds the velocities and impulses of bodies in touch at once. Velocities minimise their distance from free ones, by
 * mass, and half the square of what contacts push over their penalty; impulses are then what they push. Each round of
 * that (the method of multipliers) brings the speeds nearer to what Coulomb's law asks for: what lies still begins with
 * the impulses of the last step, and is done before the first matrix.
 */
export class Newton {
  readonly #matrix: PartMatrix;
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: SolveBodies;
  #part!: Part;
  #creeping = CREEPING;
  #miss = MISS;
  #nearly = 0;
  #still = STILL;
  /** A change of velocities that ends a round. */
  #end = STILL;
  /** Share of its speed, or of what weight gives in a step, that what hangs together or is rough may miss by, besides. */
  loose = 0;
  /** Matrices that it may factor, and did. */
  #most = Infinity;
  used = 0;
  /** Its velocities did not follow from its impulses any more. */
  ranAway = false;

  constructor(contacts: ConeContacts, rows: BoundRows, bodies: SolveBodies) {
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
    this.#matrix = new PartMatrix(contacts, rows, bodies);
  }

  /** False: Bullet's iterations are cheaper, or this finds no end, or none with so many matrices. */
  solve(part: Part, matrices = Infinity): boolean {
    this.#begin(part);
    this.#most = matrices;
    this.used = 0;
    this.ranAway = false;
    let speed = this.#readSlope();
    if (this.#stands(speed)) return true;
    let before = Infinity;
    let share = 1;
    for (let round = 0; round < NEWTON_ROUNDS; round++) {
      if (round > 0) speed = this.#lookAgain();
      if (!this.#minimise(speed)) return false;
      const miss = this.#raise(share);
      if (miss < this.#miss || (miss < this.#nearly && miss > STUCK * before)) return true;
      this.#foresee();
      share = miss > TO_AND_FRO * before ? 0.5 : 1;
      before = miss;
    }
    this.ranAway = !this.#follows() && !this.#followsWithoutForesight();
    return !this.ranAway;
  }

  /** Whether velocities follow from the impulses that were found with them. */
  #follows(): boolean {
    return energyGuards.explained(this.#unexplained(), this.#bodies.pace(this.#part.bodies));
  }

  #followsWithoutForesight(): boolean {
    if (this.used === 0) return false;
    const { velocities, change } = this.#bodies;
    for (const body of this.#part.bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k]! -= change[k]!;
    return this.#follows();
  }

  #begin(part: Part): void {
    this.#part = part;
    this.#matrix.begin(part);
    const many = part.bodies.length > MANY;
    this.#creeping = many ? CREEPING_OF_MANY : CREEPING;
    const loose = part.jointed || part.rough ? this.loose : 0;
    const speed = many || loose > 0 ? this.#bodies.fastestOf(part.bodies) : 0;
    this.#miss = many ? MISS_OF_MANY + MISS_SHARE * speed : MISS;
    this.#miss += loose * (speed + FALL);
    this.#nearly = many ? NEARLY * this.#miss : 0;
    this.#still = STILL + STILL_SHARE * speed;
    this.#end = this.#still + (part.rough ? ROUGH_STILL * this.#miss : 0);
    this.#readMisses();
    const c = this.#contacts.values;
    for (const i of part.contacts) {
      c[i * C.size + C.lift] = liftOf(c, i * C.size, this.#creeping);
      project(c, i * C.size, 0);
    }
  }

  /** What it begins with is its end, as far as that was kept; what joints pull is kept in double precision. */
  #stands(speed: number): boolean {
    if (speed < this.#still) return true;
    const { bodies, jointed } = this.#part;
    return bodies.length > MANY && !jointed && speed < this.#still + ROUNDED * this.#greatestLoad();
  }

  /** What contacts push a body by, all pushes taken alike: as a speed or a spin of it, m/s or rad/s. */
  #greatestLoad(): number {
    const { values: c, a, b } = this.#contacts;
    const { change, masses, inertias } = this.#bodies;
    const { bodies, contacts } = this.#part;
    for (const body of bodies) change[body * SIZE] = 0;
    for (const i of contacts) {
      const push = c[i * C.size + C.impulse]!;
      if (a[i]! >= 0) change[a[i]! * SIZE]! += push;
      if (b[i]! >= 0) change[b[i]! * SIZE]! += push;
    }
    let most = 0;
    for (const body of bodies) {
      const spin = inertias[9 * body]! + inertias[9 * body + 4]! + inertias[9 * body + 8]!;
      // At the radius of gyration about one axis.
      const perMetre = Math.sqrt((3 * masses[body]!) / spin);
      most = Math.max(most, (change[body * SIZE]! / masses[body]!) * Math.max(1, perMetre));
    }
    return most;
  }

  // ---- rounds -------------------------------------------------------------------------------------------------------

  /** What is pushed becomes the impulse. Returns by how much speeds still missed, m/s. */
  #raise(share: number): number {
    const c = this.#contacts.values;
    let worst = 0;
    for (const i of this.#part.contacts) {
      const at = i * C.size;
      const penalty = c[at + C.penalty]!;
      for (let k = 0; k < 3; k++) {
        const more = c[at + C.pushed + k]! - c[at + C.impulse + k]!;
        worst = Math.max(worst, Math.abs(more) / penalty);
        c[at + C.impulse + k]! += more;
        c[at + C.change + k] = more;
      }
      const rise = liftOf(c, at, this.#creeping) - c[at + C.lift]!;
      if (c[at + C.state] !== OPEN) worst = Math.max(worst, Math.abs(rise));
      c[at + C.lift]! += share * rise;
      c[at + C.change]! -= penalty * share * rise;
    }
    const r = this.#rows.values;
    for (const i of this.#part.rows) {
      const at = i * R.size;
      const more = r[at + R.pushed]! - r[at + R.impulse]!;
      worst = Math.max(worst, Math.abs(more) / r[at + R.penalty]!);
      r[at + R.impulse]! += more;
      r[at + R.change] = more;
    }
    return worst;
  }

  /**
   * Where velocities go by what a round changed of the pushes (`change`), as long as what sticks sticks and what slides
   * slides: by the last matrix. Otherwise stiff contacts would open first, and have to be found again (twice the matrices).
   */
  #foresee(): void {
    if (this.used === 0) return;
    const { momentum, velocities, change } = this.#bodies;
    const { bodies, contacts, rows } = this.#part;
    const { values: c, a, b } = this.#contacts;
    for (const body of bodies) momentum.fill(0, body * SIZE, (body + 1) * SIZE);
    for (const i of contacts)
      if (answerTo(c, i * C.size)) takePush(c, i * C.size, momentum, a[i]!, b[i]!, C.change, 1);
    const r = this.#rows;
    for (const i of rows) {
      const at = i * R.size;
      if (gives(r.values, at))
        takeAlong(r.values, at, momentum, r.a[i]!, r.b[i]!, r.values[at + R.change]!);
    }
    this.#matrix.solve();
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k]! += change[k]!;
  }

  // ---- one round ----------------------------------------------------------------------------------------------------

  /** Where another round begins; returns the slope there. */
  #lookAgain(): number {
    this.#readMisses();
    return this.#readSlope();
  }

  /** From where the slope is `speed` on. */
  #minimise(speed: number): boolean {
    for (let step = 0; step < NEWTON_STEPS; step++) {
      if (step > 0) speed = this.#readSlope();
      if (speed < this.#end) return true;
      if (this.used++ >= this.#most || !this.#matrix.factor()) return false;
      // Newton's direction goes to `change`.
      const size = this.#matrix.solve();
      // However small it is: contacts are stiff, and what it changes in what they push is not.
      this.#go();
      if (size < this.#end) return true;
    }
    return true;
  }

  #readMisses(): void {
    const { values: c, a, b } = this.#contacts;
    const { velocities } = this.#bodies;
    for (const i of this.#part.contacts) {
      const at = i * C.size;
      speeds(c, at, velocities, a[i]!, b[i]!, C.miss);
      c[at + C.miss]! -= c[at + C.target]!;
      c[at + C.miss + 1]! -= c[at + C.target + 1]!;
      c[at + C.miss + 2]! -= c[at + C.target + 2]!;
      project(c, at, 0);
    }
    const r = this.#rows;
    for (const i of this.#part.rows) {
      const at = i * R.size;
      r.values[at + R.miss] =
        rate(r.values, at, velocities, r.a[i]!, r.b[i]!) - r.values[at + R.target]!;
      clamp(r.values, at, 0);
    }
  }

  /** The gradient goes to `momentum`. Returns the greatest speed that it would take from a body by itself. */
  #readSlope(): number {
    return this.#slope(C.pushed, R.pushed);
  }

  /** The same of the impulses that were found: the greatest speed that does not follow from them. */
  #unexplained(): number {
    return this.#slope(C.impulse, R.impulse);
  }

  #slope(pushes: number, pushesOfRows: number): number {
    const { values: c, a, b } = this.#contacts;
    const { momentum } = this.#bodies;
    const { bodies } = this.#part;
    this.#bodies.gradient(bodies);
    for (const i of this.#part.contacts) takePush(c, i * C.size, momentum, a[i]!, b[i]!, pushes, 1);
    const r = this.#rows;
    for (const i of this.#part.rows) {
      const at = i * R.size;
      takeAlong(r.values, at, momentum, r.a[i]!, r.b[i]!, r.values[at + pushesOfRows]!);
    }
    return this.#bodies.fastest(bodies);
  }

  /** Along the direction found, as far as that goes down. */
  #go(): void {
    const { velocities, change } = this.#bodies;
    const { bodies, contacts, rows } = this.#part;
    const { values: c, a, b } = this.#contacts;
    const r = this.#rows;
    for (const i of contacts) speeds(c, i * C.size, change, a[i]!, b[i]!, C.change);
    for (const i of rows)
      r.values[i * R.size + R.change] = rate(r.values, i * R.size, change, r.a[i]!, r.b[i]!);
    const s = this.#findBottom();
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k]! += s * change[k]!;
    for (const i of contacts) {
      const m = i * C.size + C.miss;
      const d = i * C.size + C.change;
      c[m]! += s * c[d]!;
      c[m + 1]! += s * c[d + 1]!;
      c[m + 2]! += s * c[d + 2]!;
    }
    for (const i of rows) r.values[i * R.size + R.miss]! += s * r.values[i * R.size + R.change]!;
  }

  /** How far along the direction the slope ends: by false position, after Illinois. */
  #findBottom(): number {
    const { bodies } = this.#part;
    const begin = this.#bodies.along(bodies);
    const curve = this.#bodies.square(bodies);
    const constant = begin + this.#power();
    let low = 0;
    let atLow = begin;
    let high = 1;
    let atHigh = NaN;
    let s = 1;
    for (let i = 0; i < LINE_TRIES; i++) {
      const slope = constant + s * curve - this.#powerAt(s);
      if (slope <= LINE_FLAT * -begin && (s === 1 || slope >= LINE_FLAT * begin)) break;
      if (slope > 0) {
        high = s;
        atHigh = slope;
        if (i > 0) atLow /= 2;
      } else {
        low = s;
        atLow = slope;
        atHigh /= 2;
      }
      s = low - ((high - low) * atLow) / (atHigh - atLow);
    }
    return s;
  }

  /** What the pushes do along the direction, `s` of it gone. */
  #powerAt(s: number): number {
    const c = this.#contacts.values;
    const r = this.#rows.values;
    let sum = 0;
    for (const i of this.#part.contacts) {
      project(c, i * C.size, s);
      sum = withPower(c, i * C.size, sum);
    }
    for (const i of this.#part.rows) {
      clamp(r, i * R.size, s);
      sum += r[i * R.size + R.pushed]! * r[i * R.size + R.change]!;
    }
    return sum;
  }

  /** The same as they are. */
  #power(): number {
    const c = this.#contacts.values;
    const r = this.#rows.values;
    let sum = 0;
    for (const i of this.#part.contacts) sum = withPower(c, i * C.size, sum);
    for (const i of this.#part.rows) sum += r[i * R.size + R.pushed]! * r[i * R.size + R.change]!;
    return sum;
  }

  // ---- overlaps -----------------------------------------------------------------------------------------------------

  /**
   * How bodies move apart that overlap, metres and radians, goes to `change`. What touches holds on to each other
   * meanwhile. False: nothing overlaps.
   */
  pushApart(): boolean {
    if (!this.#anyOverlap() || !this.#hold()) return false;
    const { values: c, a, b } = this.#contacts;
    const { momentum } = this.#bodies;
    for (const body of this.#part.bodies) momentum.fill(0, body * SIZE, (body + 1) * SIZE);
    for (const i of this.#part.contacts) {
      const at = i * C.size;
      if (c[at + C.state] === OPEN) continue;
      c[at + C.change] = c[at + C.penalty]! * c[at + C.overlap]!;
      c[at + C.change + 1] = c[at + C.change + 2] = 0;
      takePush(c, at, momentum, a[i]!, b[i]!, C.change, 1);
    }
    this.#matrix.solve();
    return true;
  }

  #anyOverlap(): boolean {
    const c = this.#contacts.values;
    for (const i of this.#part.contacts) if (c[i * C.size + C.overlap]! > SHALLOW) return true;
    return false;
  }

  #hold(): boolean {
    const c = this.#contacts.values;
    for (const i of this.#part.contacts) {
      const at = i * C.size;
      if (c[at + C.state] === SLIDES || c[at + C.overlap]! > SHALLOW) c[at + C.state] = STICKS;
    }
    return this.#matrix.factor();
  }
}

/** The sum and what a contact's push does along the direction. */
const withPower = (c: Float64Array, at: number, sum: number): number =>
  sum +
  c[at + C.pushed]! * c[at + C.change]! +
  c[at + C.pushed + 1]! * c[at + C.change + 1]! +
  c[at + C.pushed + 2]! * c[at + C.change + 2]!;

/**
 * What Coulomb's law has more than its associated form: sliding does not lift. Next to rest that form itself is taken,
 * which always finds its end.
 */
const liftOf = (c: Float64Array, at: number, creeping: number): number =>
  c[at + C.friction]! * Math.max(0, hypot(c[at + C.miss + 1]!, c[at + C.miss + 2]!) - creeping);
