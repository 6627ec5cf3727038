import { cross3, dot3 } from '../../base/flat-math.js';
import { R, rate, type BoundRows } from '../rows/bound-rows.js';
import { C, speeds, type ConeContacts } from '../rows/cone-contacts.js';
import type { Part } from '../part.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';
import {
  MISS_OF_MANY,
  PUSHES,
  SHALLOW,
  SWEEPS,
  SWEEPS_OF_JOINTED,
  SWEEPS_OF_SLOW,
} from '../tolerances.js';

/** Numbers by contact of how its speeds answer: normal, normal and each along it, then those along it. */
const ANSWERS = 6;

/**
 * Goes over contacts one at a time (Gauss–Seidel), there and back. Impulses begin with all that the last step ended with,
 * friction too, so that what lies goes on where it was. Bullet's iterations do the same, but with .85 of the normal
 * impulses and none of friction's: in a large heap they begin so far from the end that it never comes to rest.
 */
export class Sweeps {
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: SolveBodies;
  /** By contact: how its speeds answer its impulses; the upper half of a symmetric 3 × 3. */
  #answers = new Float64Array(ANSWERS);
  readonly #turns = new Float64Array(9);
  readonly #spin = new Float64Array(3);
  #part!: Part;
  /** All that it goes over are. */
  slow = false;

  constructor(contacts: ConeContacts, rows: BoundRows, bodies: SolveBodies) {
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
  }

  /** False: numbers that are none. */
  solve(part: Part): boolean {
    this.#part = part;
    this.#begin();
    const times = part.jointed ? SWEEPS_OF_JOINTED : this.slow ? SWEEPS_OF_SLOW : SWEEPS;
    let worst = Infinity;
    for (let i = 0; i < times && worst >= MISS_OF_MANY; i++) worst = this.#sweep(i % 2 === 1);
    return Number.isFinite(worst);
  }

  // ---- velocities ---------------------------------------------------------------------------------------------------

  #begin(): void {
    const { velocities, free } = this.#bodies;
    for (const body of this.#part.bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k] = free[k]!;
    const c = this.#contacts.values;
    const room = ANSWERS * this.#contacts.count;
    if (this.#answers.length < room) this.#answers = new Float64Array(2 * room);
    for (const i of this.#part.contacts) {
      this.#readAnswers(i);
      const p = i * C.size + C.impulse;
      this.#write(i, c[p]!, c[p + 1]!, c[p + 2]!);
      this.#kick(velocities, i, c[p]!, c[p + 1]!, c[p + 2]!);
    }
    for (const i of this.#part.rows) this.#pull(i, this.#rows.values[i * R.size + R.impulse]!);
  }

  #sweep(back: boolean): number {
    const { contacts, rows } = this.#part;
    let worst = 0;
    const last = contacts.length - 1;
    for (let j = 0; j <= last; j++)
      worst = Math.max(worst, this.#hold(contacts[back ? last - j : j]!));
    for (const i of rows) worst = Math.max(worst, this.#keep(i));
    return worst;
  }

  /** One contact by itself. Returns by how much its normal speed was changed, or that along it, m/s. */
  #hold(i: number): number {
    const { values: c, a, b } = this.#contacts;
    const at = i * C.size;
    const w = this.#answers;
    const d = i * ANSWERS;
    speeds(c, at, this.#bodies.velocities, a[i]!, b[i]!, C.miss);
    const p = at + C.impulse;
    const n = c[p]!;
    const t = c[p + 1]!;
    const u = c[p + 2]!;
    const dn = Math.max(-n, (c[at + C.target]! - c[at + C.miss]!) / w[d]!);
    const dt = (c[at + C.target + 1]! - c[at + C.miss + 1]! - w[d + 1]! * dn) / w[d + 3]!;
    const missed = c[at + C.target + 2]! - c[at + C.miss + 2]! - w[d + 2]! * dn - w[d + 4]! * dt;
    this.#write(i, n + dn, t + dt, u + missed / w[d + 5]!);
    const et = c[p + 1]! - t;
    const eu = c[p + 2]! - u;
    this.#kick(this.#bodies.velocities, i, dn, et, eu);
    return Math.max(Math.abs(dn) * w[d]!, Math.abs(et) * w[d + 3]!, Math.abs(eu) * w[d + 5]!);
  }

  /** A joint's row, or what keeps one body from turning, within its bounds. Returns by how much its rate was changed. */
  #keep(i: number): number {
    const { values: r, a, b } = this.#rows;
    const at = i * R.size;
    const gives = this.#givesOf(i) || 1;
    const missed = r[at + R.target]! - rate(r, at, this.#bodies.velocities, a[i]!, b[i]!);
    const before = r[at + R.impulse]!;
    const now = Math.min(r[at + R.most]!, Math.max(r[at + R.least]!, before + missed / gives));
    r[at + R.impulse] = now;
    this.#pull(i, now - before);
    return Math.abs(now - before) * gives;
  }

  /** What an impulse of 1 N s, or a moment of 1 N m s, makes of its rate. */
  #givesOf(i: number): number {
    const { a, b } = this.#rows;
    return this.#givesOfBody(i * R.size + R.a, a[i]!) + this.#givesOfBody(i * R.size + R.b, b[i]!);
  }

  #givesOfBody(at: number, body: number): number {
    if (body < 0) return 0;
    const { values: r } = this.#rows;
    const { masses, inverseInertias } = this.#bodies;
    let sum = dot3(r, at, r, at) / masses[body]!;
    for (let k = 0; k < 3; k++)
      sum += r[at + 3 + k]! * dot3(inverseInertias, 9 * body + 3 * k, r, at + 3);
    return sum;
  }

  #pull(i: number, impulse: number): void {
    const { a, b } = this.#rows;
    this.#pullBody(i * R.size + R.a, a[i]!, impulse);
    this.#pullBody(i * R.size + R.b, b[i]!, impulse);
  }

  #pullBody(at: number, body: number, impulse: number): void {
    if (body < 0) return;
    const { values: r } = this.#rows;
    const { velocities, masses, inverseInertias } = this.#bodies;
    for (let k = 0; k < 3; k++) {
      velocities[SIZE * body + k]! += (impulse * r[at + k]!) / masses[body]!;
      velocities[SIZE * body + 3 + k]! +=
        impulse * dot3(inverseInertias, 9 * body + 3 * k, r, at + 3);
    }
  }

  /** Impulses, as Coulomb's law allows them. */
  #write(i: number, n: number, t: number, u: number): void {
    const c = this.#contacts.values;
    const at = i * C.size;
    const most = c[at + C.friction]! * n;
    const along = Math.sqrt(t * t + u * u);
    const share = along > most ? most / along : 1;
    c[at + C.impulse] = n;
    c[at + C.impulse + 1] = share * t;
    c[at + C.impulse + 2] = share * u;
  }

  // ---- overlaps -----------------------------------------------------------------------------------------------------

  /** How bodies move apart that overlap, metres and radians, goes to `change`. */
  pushApart(): boolean {
    // Each body by itself would tear them.
    if (this.#part.jointed) return false;
    const c = this.#contacts.values;
    const { change } = this.#bodies;
    const { bodies, contacts } = this.#part;
    let any = false;
    for (const body of bodies) change.fill(0, body * SIZE, (body + 1) * SIZE);
    for (const i of contacts) {
      c[i * C.size + C.pushed] = 0;
      any ||= c[i * C.size + C.overlap]! > SHALLOW;
    }
    if (!any) return false;
    for (let s = 0; s < PUSHES; s++) this.#separateAll(s % 2 === 1);
    return true;
  }

  /** There and back, too: in one direction alone, what is left of each step adds up, and heaps sink by millimetres a second. */
  #separateAll(back: boolean): void {
    const { contacts } = this.#part;
    const last = contacts.length - 1;
    for (let j = 0; j <= last; j++) this.#separate(contacts[back ? last - j : j]!);
  }

  #separate(i: number): void {
    const { values: c, a, b } = this.#contacts;
    const at = i * C.size;
    if (c[at + C.impulse] === 0 && c[at + C.overlap] === 0) return;
    speeds(c, at, this.#bodies.change, a[i]!, b[i]!, C.miss);
    const before = c[at + C.pushed]!;
    const n = Math.max(
      0,
      before - (c[at + C.miss]! - c[at + C.overlap]!) / this.#answers[i * ANSWERS]!,
    );
    c[at + C.pushed] = n;
    this.#kick(this.#bodies.change, i, n - before, 0, 0);
  }

  // ---- what impulses do ---------------------------------------------------------------------------------------------

  /** How fast an impulse of 1 N s along one of its directions makes a contact along another, m/s. */
  #readAnswers(i: number): void {
    const { values: c, a, b } = this.#contacts;
    this.#answers.fill(0, i * ANSWERS, (i + 1) * ANSWERS);
    if (a[i]! >= 0) this.#addAnswers(i, a[i]!, c, i * C.size + C.armA);
    if (b[i]! >= 0) this.#addAnswers(i, b[i]!, c, i * C.size + C.armB);
  }

  #addAnswers(i: number, body: number, c: Float64Array, arm: number): void {
    const { masses, inverseInertias } = this.#bodies;
    const turns = this.#turns;
    const w = this.#answers;
    for (let k = 0; k < 3; k++) cross3(turns, 3 * k, c, arm, c, i * C.size + 3 * k);
    let d = i * ANSWERS;
    for (let k = 0; k < 3; k++) {
      for (let m = 0; m < 3; m++)
        this.#spin[m] = dot3(inverseInertias, 9 * body + 3 * m, turns, 3 * k);
      for (let l = k; l < 3; l++)
        w[d++]! += dot3(turns, 3 * l, this.#spin, 0) + (l === k ? 1 / masses[body]! : 0);
    }
  }

  #kick(v: Float64Array, i: number, n: number, t: number, u: number): void {
    const { values: c, a, b } = this.#contacts;
    const at = i * C.size;
    const x = n * c[at]! + t * c[at + 3]! + u * c[at + 6]!;
    const y = n * c[at + 1]! + t * c[at + 4]! + u * c[at + 7]!;
    const z = n * c[at + 2]! + t * c[at + 5]! + u * c[at + 8]!;
    if (a[i]! >= 0) this.#kickBody(v, a[i]!, c, at + C.armA, x, y, z);
    if (b[i]! >= 0) this.#kickBody(v, b[i]!, c, at + C.armB, -x, -y, -z);
  }

  #kickBody(
    v: Float64Array,
    body: number,
    c: Float64Array,
    arm: number,
    x: number,
    y: number,
    z: number,
  ): void {
    const { masses, inverseInertias: w } = this.#bodies;
    const i = SIZE * body;
    const j = 9 * body;
    const share = 1 / masses[body]!;
    const p = c[arm + 1]! * z - c[arm + 2]! * y;
    const q = c[arm + 2]! * x - c[arm]! * z;
    const r = c[arm]! * y - c[arm + 1]! * x;
    v[i]! += share * x;
    v[i + 1]! += share * y;
    v[i + 2]! += share * z;
    v[i + 3]! += w[j]! * p + w[j + 1]! * q + w[j + 2]! * r;
    v[i + 4]! += w[j + 3]! * p + w[j + 4]! * q + w[j + 5]! * r;
    v[i + 5]! += w[j + 6]! * p + w[j + 7]! * q + w[j + 8]! * r;
  }
}
