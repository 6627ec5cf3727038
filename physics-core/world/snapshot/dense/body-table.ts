import { HOW, NO_LIST, type Moment } from '../snapshot.js';
import { goingOn, likeBefore, Table, wordOf, type Guess } from './table.js';

// Bodies by their ids, a row each: id, flag, state, and the box that they have in Bullet's broadphase.

/** Numbers of a state, and of a box. */
const STATE = 18;
const BOX = 6;

const FLAGS = 1;
const FIRST = 2;
const BOXES = FIRST + STATE;
const COLUMNS = BOXES + BOX;

/** Of a state: the last row of the rotation, the origin, the velocities. */
const LAST_ROW = FIRST + 6;
const ORIGIN = FIRST + 9;
const LINEAR = FIRST + 12;
const ANGULAR = FIRST + 15;

/** The others of three. */
const NEXT = [1, 2, 0] as const;
const AFTER = [2, 0, 1] as const;

/** Numbers of a frame: the rows of the rotation, the origin. */
export const FRAME = 12;

export class BodyTable extends Table {
  readonly #before: Int32Array;

  constructor(rows: number) {
    super(COLUMNS, rows);
    this.#before = likeBefore(rows);
  }

  hasBox(row: number): boolean {
    return hasBox(this.word(FLAGS, row));
  }

  take({ ids, flags, states, boxes }: Moment): void {
    const { words, floats, rows } = this;
    words.set(ids);
    words.set(flags, rows);
    let box = 0;
    for (let row = 0; row < rows; row++) {
      for (let i = 0; i < STATE; i++) floats[(FIRST + i) * rows + row] = states[row * STATE + i]!;
      if (hasBox(flags[row]!))
        for (let i = 0; i < BOX; i++) floats[(BOXES + i) * rows + row] = boxes[box++]!;
    }
  }

  give(): Pick<Moment, 'ids' | 'flags' | 'states' | 'boxes'> {
    const { words, floats, rows } = this;
    const flags = Uint8Array.from(words.subarray(rows, 2 * rows));
    const states = new Float32Array(STATE * rows);
    const boxes = new Float32Array(BOX * flags.filter(hasBox).length);
    let box = 0;
    for (let row = 0; row < rows; row++) {
      for (let i = 0; i < STATE; i++) states[row * STATE + i] = floats[(FIRST + i) * rows + row]!;
      if (hasBox(flags[row]!))
        for (let i = 0; i < BOX; i++) boxes[box++] = floats[(BOXES + i) * rows + row]!;
    }
    return { ids: [...words.subarray(0, rows)], flags, states, boxes };
  }

  /** Bodies lie alike; a rotation's last row is square to the others, and a box goes along with its body. */
  readonly guesses = (column: number): Guess => {
    if (column === 0) return goingOn(this, 0);
    if (column >= LAST_ROW && column < ORIGIN)
      return (row) => wordOf(this.#square(column - LAST_ROW, row));
    if (column < BOXES) return this.#before;
    const { floats, rows } = this;
    const box = column * rows;
    const origin = (ORIGIN + ((column - BOXES) % 3)) * rows;
    return (row) =>
      row === 0
        ? 0
        : wordOf(floats[origin + row]! + floats[box + row - 1]! - floats[origin + row - 1]!);
  };

  #square(k: number, row: number): number {
    const { floats, rows } = this;
    const next = (FIRST + NEXT[k]!) * rows + row;
    const after = (FIRST + AFTER[k]!) * rows + row;
    const below = 3 * rows;
    return floats[next]! * floats[after + below]! - floats[after]! * floats[next + below]!;
  }

  /** Where bodies in the world stood at the start of a step of `dt` seconds, by rank: the rows of the rotation, the origin. */
  framesBefore(dt: number): Float64Array {
    const frames = new Float64Array(FRAME * this.rows);
    let at = 0;
    for (let row = 0; row < this.rows; row++) {
      if (!this.hasBox(row)) continue;
      for (let column = 0; column < 3; column++)
        this.#turnBack(frames, at + column, row, column, dt);
      for (let k = 0; k < 3; k++)
        frames[at + 9 + k] = this.float(ORIGIN + k, row) - dt * this.float(LINEAR + k, row);
      at += FRAME;
    }
    return frames;
  }

  /** One axis of the body, by a turn in second order. */
  #turnBack(frames: Float64Array, at: number, row: number, column: number, dt: number): void {
    const x = -dt * this.float(ANGULAR, row);
    const y = -dt * this.float(ANGULAR + 1, row);
    const z = -dt * this.float(ANGULAR + 2, row);
    const a = this.float(FIRST + column, row);
    const b = this.float(FIRST + 3 + column, row);
    const c = this.float(FIRST + 6 + column, row);
    const u = y * c - z * b;
    const v = z * a - x * c;
    const w = x * b - y * a;
    frames[at] = a + u + (y * w - z * v) / 2;
    frames[at + 3] = b + v + (z * u - x * w) / 2;
    frames[at + 6] = c + w + (x * v - y * u) / 2;
  }

  /** How large the boxes of bodies in the world are, by rank. */
  get sizes(): number[] {
    const sizes: number[] = [];
    for (let row = 0; row < this.rows; row++) {
      if (!this.hasBox(row)) continue;
      let size = 0;
      for (let k = 0; k < 3; k++)
        size += this.float(BOXES + 3 + k, row) - this.float(BOXES + k, row);
      sizes.push(size);
    }
    return sizes;
  }
}

const hasBox = (flag: number): boolean => Math.floor(flag / HOW) !== NO_LIST;
