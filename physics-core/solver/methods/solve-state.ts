import { R, type BoundRows } from '../rows/bound-rows.js';
import { C, type ConeContacts } from '../rows/cone-contacts.js';
import type { Part } from '../part.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';

/** What a solution of a part begins with and leaves: velocities of bodies, impulses of contacts and rows. */
export class SolveState {
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: SolveBodies;
  #values = new Float64Array(0);

  constructor(contacts: ConeContacts, rows: BoundRows, bodies: SolveBodies) {
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
  }

  keep(part: Part): void {
    const size = SIZE * part.bodies.length + 3 * part.contacts.length + part.rows.length;
    if (this.#values.length < size) this.#values = new Float64Array(2 * size);
    const kept = this.#values;
    const { velocities } = this.#bodies;
    const c = this.#contacts.values;
    const r = this.#rows.values;
    let at = 0;
    for (const body of part.bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) kept[at++] = velocities[k]!;
    for (const i of part.contacts)
      for (let k = i * C.size; k < i * C.size + 3; k++) kept[at++] = c[k + C.impulse]!;
    for (const i of part.rows) kept[at++] = r[i * R.size + R.impulse]!;
  }

  putBack(part: Part): void {
    const kept = this.#values;
    const { velocities } = this.#bodies;
    const c = this.#contacts.values;
    const r = this.#rows.values;
    let at = 0;
    for (const body of part.bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k] = kept[at++]!;
    for (const i of part.contacts)
      for (let k = i * C.size; k < i * C.size + 3; k++) c[k + C.impulse] = kept[at++]!;
    for (const i of part.rows) r[i * R.size + R.impulse] = kept[at++]!;
  }
}
