import { stiffnessOf, C, type ConeContacts } from '../rows/cone-contacts.js';
import { addContact, PLACES, placesOf } from '../rows/contact-blocks.js';
import { addOuter, addSquare, gives, isBounded, R, type BoundRows } from '../rows/bound-rows.js';
import type { Part } from '../part.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE, SparseCholesky } from '../matrix/block-cholesky.js';
import { PRODUCTS_PER_BODY } from '../tolerances.js';

/** How what a part's contacts and joints push answers velocities, with the masses: Newton's matrix. */
export class PartMatrix {
  /**
   * Parts are numbered as in the step before, and who touches whom in each of them mostly is as it was: what was found of the
   * pattern of each stands.
   */
  readonly #matrices = new WeakMap<Part, SparseCholesky>();
  #matrix!: SparseCholesky;
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: SolveBodies;
  #x = new Float64Array(SIZE);
  readonly #w = new Float64Array(9);
  /** By body: its number in the part. */
  #number = new Int32Array(16);
  /** By contact of the part: where its blocks are. */
  #places = new Int32Array(16);
  #part!: Part;
  /** What does not change in a step is in it. */
  #begun = false;

  constructor(contacts: ConeContacts, rows: BoundRows, bodies: SolveBodies) {
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
  }

  begin(part: Part): void {
    this.#part = part;
    this.#begun = false;
    const { count } = this.#bodies;
    if (this.#number.length < count) this.#number = new Int32Array(2 * count);
    if (this.#x.length < SIZE * count) this.#x = new Float64Array(2 * SIZE * count);
  }

  /** As contacts and rows are now. False: it takes too much work, or has no end. */
  factor(): boolean {
    if (!this.#begun && !this.#beginMatrix()) return false;
    const c = this.#contacts.values;
    const matrix = this.#matrix;
    const { contacts, rows } = this.#part;
    const places = this.#places;
    matrix.restore();
    for (let j = 0; j < contacts.length; j++) {
      const at = contacts[j]! * C.size;
      if (stiffnessOf(c, at, this.#w))
        addContact(matrix.values, this.#w, c, at, places, j * PLACES);
    }
    for (const i of rows)
      if (this.#isBounded(i) && gives(this.#rows.values, i * R.size)) this.#addRow(i);
    return matrix.factor();
  }

  /** Masses and what joints hold are the same in all of a step: only once a matrix is needed. */
  #beginMatrix(): boolean {
    const matrix = (this.#matrix = this.#matrixOf(this.#part));
    const { bodies, rows } = this.#part;
    if (!this.#analyse()) return false;
    matrix.clear();
    for (let i = 0; i < bodies.length; i++)
      this.#bodies.addMass(bodies[i]!, matrix.values, matrix.diagonal(i));
    for (const i of rows) if (!this.#isBounded(i)) this.#addRow(i);
    this.#findPlaces();
    return (this.#begun = matrix.factorConstant());
  }

  /** Contacts are added anew for each matrix of a step, and always to the same blocks. */
  #findPlaces(): void {
    const { contacts } = this.#part;
    const { a, b } = this.#contacts;
    if (this.#places.length < contacts.length * PLACES)
      this.#places = new Int32Array(2 * contacts.length * PLACES);
    for (let j = 0; j < contacts.length; j++) {
      const i = contacts[j]!;
      const p = this.#numberOf(a[i]!);
      const q = this.#numberOf(b[i]!);
      placesOf(this.#matrix, p, q, this.#places, j * PLACES);
    }
  }

  #matrixOf(part: Part): SparseCholesky {
    let matrix = this.#matrices.get(part);
    if (!matrix) this.#matrices.set(part, (matrix = new SparseCholesky()));
    return matrix;
  }

  #analyse(): boolean {
    const { bodies, contacts, rows } = this.#part;
    const matrix = this.#matrix;
    matrix.begin(bodies.length);
    for (let i = 0; i < bodies.length; i++) this.#number[bodies[i]!] = i;
    for (const i of contacts) this.#connect(this.#contacts.a[i]!, this.#contacts.b[i]!, true);
    for (const i of rows) this.#connect(this.#rows.a[i]!, this.#rows.b[i]!, this.#isBounded(i));
    return matrix.analyse(PRODUCTS_PER_BODY * bodies.length);
  }

  #connect(a: number, b: number, changes: boolean): void {
    const p = this.#numberOf(a);
    const q = this.#numberOf(b);
    if (p >= 0 && q >= 0) this.#matrix.connect(p, q);
    if (changes) for (const i of [p, q]) if (i >= 0) this.#matrix.changes(i);
  }

  #isBounded(i: number): boolean {
    return isBounded(this.#rows.values, i * R.size);
  }

  #numberOf(body: number): number {
    return body < 0 ? -1 : this.#number[body]!;
  }

  #addRow(i: number): void {
    const { values: r, a, b } = this.#rows;
    const matrix = this.#matrix;
    const at = i * R.size;
    const penalty = r[at + R.penalty]!;
    const p = this.#numberOf(a[i]!);
    const q = this.#numberOf(b[i]!);
    if (p >= 0) addSquare(matrix.values, matrix.diagonal(p), r, at, penalty);
    if (q >= 0) addSquare(matrix.values, matrix.diagonal(q), r, at + R.b, penalty);
    if (p < 0 || q < 0) return;
    const between = matrix.between(p, q);
    if (between >= 0) addOuter(matrix.values, between, r, at, at + R.b, penalty);
    else addOuter(matrix.values, -1 - between, r, at + R.b, at, penalty);
  }

  /** What takes the bodies' `momentum` away goes to `change`; returns its greatest speed. */
  solve(): number {
    const { momentum, change } = this.#bodies;
    const { bodies } = this.#part;
    const x = this.#x;
    for (let i = 0; i < bodies.length; i++)
      for (let k = 0; k < SIZE; k++) x[i * SIZE + k] = -momentum[bodies[i]! * SIZE + k]!;
    this.#matrix.solve(x);
    let size = 0;
    for (let i = 0; i < bodies.length; i++)
      for (let k = 0; k < SIZE; k++) {
        const value = x[i * SIZE + k]!;
        change[bodies[i]! * SIZE + k] = value;
        size = Math.max(size, Math.abs(value));
      }
    return size;
  }
}
