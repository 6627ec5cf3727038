import { hypot } from '../../../base/exact/index.js';
import { FRAME } from './body-table.js';
import { likeBefore, Table, wordOf, type Guess } from './table.js';

// Contact points, a row each, in the order of their manifolds, as `saveContacts` has them. Of each, its own side is the
// smaller of its bodies: a corner of that is mostly where it was on the one before.

/** Points that a manifold holds. */
const MOST_POINTS = 4;

/** Columns of `saveContacts`. */
const GIVEN = {
  local: [0, 3],
  onB: 6,
  normal: 9,
  distance: 12,
  impulse: 13,
  surface: 14,
  lateral: 23,
  ways: 27,
};

const next = (first: number, count: number): number[] =>
  Array.from({ length: count }, (_, i) => first + i);

/** Each of ours is one of those: where A is its own side, and where B is. */
const COLUMNS = ([0, 1] as const).map((own) =>
  Int32Array.of(
    ...next(GIVEN.normal, 3),
    GIVEN.distance,
    ...next(GIVEN.local[own]!, 3),
    ...next(GIVEN.onB, 3),
    ...next(GIVEN.local[1 - own]!, 3),
    GIVEN.impulse,
    ...next(GIVEN.lateral, 4),
    ...next(GIVEN.surface, 9),
    ...next(GIVEN.ways, 6),
  ),
);
const COUNT = COLUMNS[0]!.length;

/** Where ours begin. */
const DISTANCE = 3;
const OWN = 4;
const ON_B = 7;
const OTHER = 10;
const IMPULSE = 13;
const SURFACE = 18;
const FIRST_WAY = 27;

/** Manifolds with points, a row each: the rank of A, and that of B with how many points. */
export class ManifoldTable extends Table {
  readonly #before: Int32Array;

  constructor(rows: number) {
    super(2, rows);
    this.#before = likeBefore(rows);
  }

  readonly guesses = (): Guess => this.#before;

  a(row: number): number {
    return this.word(0, row);
  }

  b(row: number): number {
    return Math.floor(this.word(1, row) / MOST_POINTS);
  }

  count(row: number): number {
    return 1 + (this.word(1, row) & (MOST_POINTS - 1));
  }

  get points(): number {
    let points = 0;
    for (let row = 0; row < this.rows; row++) points += this.count(row);
    return points;
  }
}

export class PointTable extends Table {
  readonly #frames: Float64Array;
  readonly manifolds: ManifoldTable;

  /** Of each point its manifold, and the rows of those that it is like: in its own manifold, and in the one before. */
  readonly #manifold: Int32Array;
  readonly #own: Uint8Array;
  readonly #beside: Int32Array;
  readonly #before: Int32Array;
  readonly #way = new Float64Array(3);
  #wayOf = -1;

  /** `frames`, `sizes`: of bodies, by their ranks. */
  constructor(manifolds: ManifoldTable, frames: Float64Array, sizes: readonly number[]) {
    super(COUNT, manifolds.points);
    const { rows } = this;
    this.manifolds = manifolds;
    this.#frames = frames;
    this.#manifold = new Int32Array(rows);
    this.#own = new Uint8Array(rows);
    this.#beside = new Int32Array(rows);
    this.#before = new Int32Array(rows);
    let first = 0;
    let last = -1;
    for (let m = 0; m < manifolds.rows; m++) {
      const count = manifolds.count(m);
      const own = sizes[manifolds.a(m)]! <= sizes[manifolds.b(m)]! ? 0 : 1;
      for (let row = first; row < first + count; row++) {
        this.#manifold[row] = m;
        this.#own[row] = own;
        this.#before[row] = last < 0 ? row - 1 : Math.min(last + row - first, first - 1);
        this.#beside[row] = row === first ? last : row - 1;
      }
      last = first;
      first += count;
    }
  }

  /** From `given`, whose columns begin there; of those that are the same all over one word. */
  take(given: Int32Array, begins: Int32Array, same: readonly boolean[]): void {
    const { words, rows } = this;
    for (let row = 0; row < rows; row++) {
      const columns = COLUMNS[this.#own[row]!]!;
      for (let column = 0, at = row; column < COUNT; column++, at += rows) {
        const from = columns[column]!;
        words[at] = given[begins[from]! + (same[from] ? 0 : row)]!;
      }
    }
  }

  /** Column by column, none of one word. */
  give(to: Int32Array, first: number): void {
    const { words, rows } = this;
    for (let row = 0; row < rows; row++) {
      const columns = COLUMNS[this.#own[row]!]!;
      for (let column = 0, at = row; column < COUNT; column++, at += rows)
        to[first + columns[column]! * (1 + rows) + 1 + row] = words[at]!;
    }
  }

  readonly guesses = (column: number): Guess => {
    if (column >= FIRST_WAY) return (row) => this.#guessWay(column, row);
    if (column >= ON_B && column < OTHER) return (row) => wordOf(this.#onB(column - ON_B, row));
    if (column >= OTHER && column < IMPULSE)
      return (row) => wordOf(this.#onOther(column - OTHER, row));
    return column < DISTANCE || column >= SURFACE ? this.#beside : this.#before;
  };

  /** The place on B, by where the point lies on its own side. */
  #onB(k: number, row: number): number {
    const manifold = this.#manifold[row]!;
    const ofB = this.#own[row] === 1;
    const rank = ofB ? this.manifolds.b(manifold) : this.manifolds.a(manifold);
    const f = this.#frames;
    const at = FRAME * rank;
    let place = f[at + 9 + k]!;
    for (let i = 0; i < 3; i++) place += f[at + 3 * k + i]! * this.float(OWN + i, row);
    return ofB ? place : place - this.float(k, row) * this.float(DISTANCE, row);
  }

  /** Where it lies on the other side, by the place on B. */
  #onOther(k: number, row: number): number {
    const manifold = this.#manifold[row]!;
    const ofB = this.#own[row] === 1;
    const at = FRAME * (ofB ? this.manifolds.a(manifold) : this.manifolds.b(manifold));
    const distance = ofB ? this.float(DISTANCE, row) : 0;
    const f = this.#frames;
    let local = 0;
    for (let i = 0; i < 3; i++) {
      const place = this.float(ON_B + i, row) + this.float(i, row) * distance;
      local += f[at + 3 * i + k]! * (place - f[at + 9 + i]!);
    }
    return local;
  }

  /** Directions of friction are those of the point beside it, or lie as Bullet lays them. */
  #guessWay(column: number, row: number): number {
    const beside = this.#beside[row]!;
    if (beside === row - 1 && this.#hasNormalOf(beside, row)) return this.word(column, beside);
    if (this.#wayOf !== row) this.#lay((this.#wayOf = row));
    const k = column - FIRST_WAY;
    return wordOf(k < 3 ? this.#way[k]! : this.#across(k - 3, row));
  }

  /** Square to the normal and the first one: to the side that the solver takes that laid it. */
  #across(k: number, row: number): number {
    const [next, after] = [(k + 1) % 3, (k + 2) % 3];
    const one = this.float(next, row) * this.float(FIRST_WAY + after, row);
    const across = one - this.float(after, row) * this.float(FIRST_WAY + next, row);
    return this.word(FIRST_WAY, row) === wordOf(this.#way[0]!) ? across : -across;
  }

  #hasNormalOf(other: number, row: number): boolean {
    if (other < 0) return false;
    for (let k = 0; k < 3; k++) if (this.word(k, other) !== this.word(k, row)) return false;
    return true;
  }

  #lay(row: number): void {
    const way = this.#way;
    const [x, y, z] = [this.float(0, row), this.float(1, row), this.float(2, row)];
    const facesZ = Math.abs(z) > Math.SQRT1_2;
    const size = facesZ ? hypot(y, z) : hypot(x, y);
    way[0] = facesZ ? 0 : -y / size;
    way[1] = facesZ ? -z / size : x / size;
    way[2] = facesZ ? y / size : 0;
  }
}
