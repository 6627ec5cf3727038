import { R, rate, type BoundRows } from '../rows/bound-rows.js';
import { C, type ConeContacts } from '../rows/cone-contacts.js';
import { energyGuards } from './energy-guards.js';
import type { Part } from '../part.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';

/**
 * Keeps contacts of jointed bodies from giving energy. Rows of joints lead along the round ways of the motion without
 * contacts; where a hard hit makes that another one, they do work that no joint does, and what is jammed gets more of it in
 * each step. Velocities beyond what was there before and what motors and carried bodies give are made less, all alike: what
 * holds at rest holds all the same. Where something is carried against them they are left alone.
 */
export class JointedEnergy {
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: SolveBodies;
  #before = 0;

  constructor(contacts: ConeContacts, rows: BoundRows, bodies: SolveBodies) {
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
  }

  /** Before velocities are looked for. */
  begin({ bodies, jointed }: Part): void {
    if (!jointed) return;
    const { free, velocities } = this.#bodies;
    this.#before = Math.max(
      this.#bodies.energyOf(bodies, free),
      this.#bodies.energyOf(bodies, velocities),
    );
  }

  /** They are found. */
  limit(part: Part): void {
    if (!part.jointed) return;
    const now = this.#bodies.energyOf(part.bodies, this.#bodies.velocities);
    // What is given is reckoned only where it counts.
    if (energyGuards.energyOfJoints(now, this.#before) || this.#isDriven(part)) return;
    const most = this.#before + this.#given(part);
    if (energyGuards.energyOfJoints(now, most)) return;
    const share = Math.sqrt(most / now);
    const { velocities } = this.#bodies;
    for (const body of part.bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k]! *= share;
  }

  #isDriven({ contacts }: Part): boolean {
    const c = this.#contacts.values;
    for (const i of contacts)
      for (let k = i * C.size + C.driven; k < i * C.size + C.driven + 3; k++)
        if (c[k] !== 0) return true;
    return false;
  }

  /** What motors, and joints with what is carried, give, J. */
  #given({ rows, curved }: Part): number {
    let sum = 0;
    for (const i of rows) if (this.#mayGive(i, curved)) sum += Math.max(0, this.#workOf(i));
    return sum;
  }

  /**
   * A motor, a stop, or a joint with something that its author may move. Where rows were laid at the end of the step, their
   * rates of before say nothing of what moves (a load of 75 kg was thrown off a chain at 17 m/s).
   */
  #mayGive(i: number, curved: boolean): boolean {
    const { values: r, a, b } = this.#rows;
    const at = i * R.size;
    const bounded = r[at + R.least]! > -Infinity || r[at + R.most]! < Infinity;
    return bounded || (!curved && (a[i]! < 0 || b[i]! < 0));
  }

  #workOf(i: number): number {
    const { values: r, a, b } = this.#rows;
    const { free, velocities } = this.#bodies;
    const at = i * R.size;
    const pace = rate(r, at, free, a[i]!, b[i]!) + rate(r, at, velocities, a[i]!, b[i]!);
    return 0.5 * r[at + R.impulse]! * pace;
  }
}
