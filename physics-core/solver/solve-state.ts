import { R } from './rows/bound-rows.js';
import { C } from './rows/cone-contacts.js';
import type { ContactSystem, Part } from './part.js';
import { SIZE } from './matrix/six-blocks.js';

/** What a solution of a part begins with and leaves: impulses of contacts and rows, velocities of bodies. */
export class SolveState {
  readonly #system: ContactSystem;
  /** As they were kept: three numbers of each contact, six of each body, one of each row. */
  values = new Float64Array(0);

  constructor(system: ContactSystem) {
    this.#system = system;
  }

  keep({ bodies, contacts, rows }: Part): void {
    const size = 3 * contacts.length + SIZE * bodies.length + rows.length;
    if (this.values.length < size) this.values = new Float64Array(2 * size);
    const kept = this.values;
    const { velocities } = this.#system.bodies;
    const c = this.#system.contacts.values;
    const r = this.#system.rows.values;
    let at = 0;
    for (const i of contacts)
      for (let k = i * C.size; k < i * C.size + 3; k++) kept[at++] = c[k + C.impulse]!;
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) kept[at++] = velocities[k]!;
    for (const i of rows) kept[at++] = r[i * R.size + R.impulse]!;
  }

  putBack(part: Part): void {
    const kept = this.values;
    const { velocities } = this.#system.bodies;
    const r = this.#system.rows.values;
    let at = this.putBackContacts(part);
    for (const body of part.bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) velocities[k] = kept[at++]!;
    for (const i of part.rows) r[i * R.size + R.impulse] = kept[at++]!;
  }

  /** Impulses of contacts alone; returns how many numbers. */
  putBackContacts({ contacts }: Part): number {
    const c = this.#system.contacts.values;
    let at = 0;
    for (const i of contacts)
      for (let k = i * C.size; k < i * C.size + 3; k++) c[k + C.impulse] = this.values[at++]!;
    return at;
  }

  /** `share` of what was kept, and the rest of what is there now. */
  blend({ bodies, contacts, rows }: Part, share: number): void {
    const kept = this.values;
    const { velocities } = this.#system.bodies;
    const c = this.#system.contacts.values;
    const r = this.#system.rows.values;
    let at = 0;
    for (const i of contacts)
      for (let k = i * C.size + C.impulse; k < i * C.size + C.impulse + 3; k++)
        c[k]! += share * (kept[at++]! - c[k]!);
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++)
        velocities[k]! += share * (kept[at++]! - velocities[k]!);
    for (const i of rows) {
      const k = i * R.size + R.impulse;
      r[k]! += share * (kept[at++]! - r[k]!);
    }
  }
}
