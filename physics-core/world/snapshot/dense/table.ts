import type { DeltaReader, DeltaWriter } from './deltas.js';

/** Words of many alike, as they stand on the heap: a column after the other. */
export class Table {
  readonly rows: number;
  readonly words: Int32Array;
  readonly floats: Float32Array;

  constructor(columns: number, rows: number) {
    this.rows = rows;
    this.words = new Int32Array(columns * rows);
    this.floats = new Float32Array(this.words.buffer);
  }

  word(column: number, row: number): number {
    return this.words[column * this.rows + row]!;
  }

  float(column: number, row: number): number {
    return this.floats[column * this.rows + row]!;
  }
}

/**
 * What a word is likely to be: what it is besides is little. Either that of the same column in another row before, which is
 * -1 where there is none, or what is said by the columns before and the rows before. Off by whatever, it costs bytes and
 * nothing else.
 */
export type Guess = Int32Array | ((row: number) => number);

type Guesses = (column: number) => Guess;

const likeIn = (words: Int32Array, first: number, row: number): number =>
  row < 0 ? 0 : words[first + row]!;

export function writeTable({ words, rows }: Table, guesses: Guesses, to: DeltaWriter): void {
  const column = new Int32Array(rows);
  for (let first = 0; first < words.length; first += rows) {
    const guess = guesses(first / rows);
    if (typeof guess === 'function')
      for (let row = 0; row < rows; row++) column[row] = words[first + row]! - guess(row);
    else
      for (let row = 0; row < rows; row++)
        column[row] = words[first + row]! - likeIn(words, first, guess[row]!);
    to.putAll(column);
  }
}

export function readTable({ words, rows }: Table, guesses: Guesses, from: DeltaReader): void {
  const column = new Int32Array(rows);
  for (let first = 0; first < words.length; first += rows) {
    const guess = guesses(first / rows);
    from.takeAll(column);
    if (typeof guess === 'function')
      for (let row = 0; row < rows; row++) words[first + row] = column[row]! + guess(row);
    else
      for (let row = 0; row < rows; row++)
        words[first + row] = column[row]! + likeIn(words, first, guess[row]!);
  }
}

/** Each is like the one before. */
export function likeBefore(rows: number): Int32Array {
  const before = new Int32Array(rows);
  for (let row = 0; row < rows; row++) before[row] = row - 1;
  return before;
}

const float = new Float32Array(1);
const word = new Int32Array(float.buffer);

/** They go on as the two before did. */
export const goingOn =
  ({ words }: Table, first: number): Guess =>
  (row) =>
    row < 2 ? 0 : 2 * words[first + row - 1]! - words[first + row - 2]!;

/** As it would stand on the heap; what is none has other bits on every machine. */
export function wordOf(number: number): number {
  float[0] = number || 0;
  return word[0]!;
}
