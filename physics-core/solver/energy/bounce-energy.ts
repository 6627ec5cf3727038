import { R, type BoundRows } from '../rows/bound-rows.js';
import { C, speeds, type ConeContacts } from '../rows/cone-contacts.js';
import { energyGuards } from './energy-guards.js';
import type { Part } from '../part.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';

/** Joules, by the share of the way from a solution without bounce to that with it: a + b s + c s². */
interface Work {
  a: number;
  b: number;
  c: number;
}

/**
 * Keeps bounces from giving energy. How fast a contact lets go is a law of that contact alone: what is wedged between two
 * and rubs, and lets go of both, comes out faster than it went in, and at the next touch again. Where contacts would do work
 * the solution is brought back towards that without bounce, as far as it takes for them to do none: both hold, and what
 * lies between them does, too, since neither contacts nor friction cones are hollow.
 */
export class BounceEnergy {
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: SolveBodies;
  /** Of the solution with all bounce: velocities, impulses of contacts, and of rows. */
  #velocities: number[] = [];
  #impulses: number[] = [];
  #pushes: number[] = [];

  constructor(contacts: ConeContacts, rows: BoundRows, bodies: SolveBodies) {
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
  }

  /**
   * Finds velocities by `solve`; without bounce by `solveRoughly` where `solve` finds none then, or such as give energy, too.
   * False: neither does.
   */
  solve(part: Part, solve: () => boolean, solveRoughly: () => boolean): boolean {
    const found = solve();
    if (!this.#bounces(part)) return found;
    if (found && this.#givesNothing(part)) return true;
    this.#keep(part);
    this.#setBounce(part, -1);
    const without = solve() && this.#givesNothing(part);
    const done = without || solveRoughly();
    this.#setBounce(part, 1);
    if (found && without) this.#blend(part, shareOf(this.#work(part)));
    return done;
  }

  #givesNothing(part: Part): boolean {
    return energyGuards.energyOfBounce(this.#excess(part));
  }

  #bounces({ contacts }: Part): boolean {
    const c = this.#contacts.values;
    for (const i of contacts) if (c[i * C.size + C.back]! > 0) return true;
    return false;
  }

  #setBounce({ contacts }: Part, sign: number): void {
    const c = this.#contacts.values;
    for (const i of contacts) c[i * C.size + C.target]! += sign * c[i * C.size + C.back]!;
  }

  /** Share of the work of contacts, all taken as positive, that they give rather than take. */
  #excess({ contacts }: Part): number {
    let sum = 0;
    let all = 0;
    for (const i of contacts) {
      const work = this.#workOf(i);
      sum += work;
      all += Math.abs(work);
    }
    return all > 0 ? sum / all : 0;
  }

  /** What a contact's impulses do to what they push apart, against what moves it by itself, J. */
  #workOf(i: number): number {
    const c = this.#contacts.values;
    const at = i * C.size;
    this.#readPace(i);
    let work = 0;
    for (let k = 0; k < 3; k++)
      work += 0.5 * c[at + C.impulse + k]! * (c[at + C.pushed + k]! + c[at + C.miss + k]!);
    return work;
  }

  /** Its speeds before go to `pushed`, those after to `miss`; what is given by an author counts as at rest. */
  #readPace(i: number): void {
    const { values: c, a, b } = this.#contacts;
    const { free, velocities } = this.#bodies;
    const at = i * C.size;
    speeds(c, at, free, a[i]!, b[i]!, C.pushed);
    // Bounce is of the approach before forces act.
    if (c[at + C.back]! > 0) c[at + C.pushed] = Math.min(c[at + C.pushed]!, c[at + C.approach]!);
    speeds(c, at, velocities, a[i]!, b[i]!, C.miss);
    for (let k = 0; k < 3; k++) {
      c[at + C.pushed + k]! -= c[at + C.driven + k]!;
      c[at + C.miss + k]! -= c[at + C.driven + k]!;
    }
  }

  #keep({ bodies, contacts, rows }: Part): void {
    const { velocities } = this.#bodies;
    const c = this.#contacts.values;
    this.#velocities = bodies.flatMap((body) => [
      ...velocities.subarray(body * SIZE, (body + 1) * SIZE),
    ]);
    this.#impulses = contacts.flatMap((i) => [
      ...c.subarray(i * C.size + C.impulse, i * C.size + C.impulse + 3),
    ]);
    this.#pushes = rows.map((i) => this.#rows.values[i * R.size + R.impulse]!);
  }

  #work({ bodies, contacts }: Part): Work {
    const { values: c, a, b } = this.#contacts;
    const { velocities, change } = this.#bodies;
    bodies.forEach((body, j) => {
      for (let k = 0; k < SIZE; k++)
        change[body * SIZE + k] = this.#velocities[j * SIZE + k]! - velocities[body * SIZE + k]!;
    });
    const work: Work = { a: 0, b: 0, c: 0 };
    contacts.forEach((i, j) => {
      const at = i * C.size;
      this.#readPace(i);
      speeds(c, at, change, a[i]!, b[i]!, C.change);
      for (let k = 0; k < 3; k++) {
        const impulse = c[at + C.impulse + k]!;
        const more = this.#impulses[3 * j + k]! - impulse;
        const pace = c[at + C.pushed + k]! + c[at + C.miss + k]!;
        const faster = c[at + C.change + k]!;
        work.a += 0.5 * impulse * pace;
        work.b += 0.5 * (more * pace + impulse * faster);
        work.c += 0.5 * more * faster;
      }
    });
    return work;
  }

  /** `share` of the solution with bounce, and the rest of that without. */
  #blend({ bodies, contacts, rows }: Part, share: number): void {
    const mixed = (without: number, all: number): number => without + share * (all - without);
    const { velocities } = this.#bodies;
    const c = this.#contacts.values;
    const r = this.#rows.values;
    bodies.forEach((body, j) => {
      for (let k = 0; k < SIZE; k++) {
        const at = body * SIZE + k;
        velocities[at] = mixed(velocities[at]!, this.#velocities[j * SIZE + k]!);
      }
    });
    contacts.forEach((i, j) => {
      for (let k = 0; k < 3; k++) {
        const at = i * C.size + C.impulse + k;
        c[at] = mixed(c[at]!, this.#impulses[3 * j + k]!);
      }
    });
    rows.forEach((i, j) => {
      const at = i * R.size + R.impulse;
      r[at] = mixed(r[at]!, this.#pushes[j]!);
    });
  }
}

/** How far from without bounce (0) to with it (1) contacts do no work: it is less than none at 0, and more at 1. */
function shareOf({ a, b, c }: Work): number {
  if (a >= 0) return 0;
  return Math.min(1, (-2 * a) / (b + Math.sqrt(Math.max(0, b * b - 4 * a * c))));
}
