import { bytesOf, pack } from '../../../base/packed.js';
import type { Moment } from '../snapshot.js';
import { BodyTable } from './body-table.js';
import { DeltaReader, DeltaWriter } from './deltas.js';
import { ManifoldTable, PointTable } from './point-table.js';
import { goingOn, likeBefore, readTable, Table, writeTable } from './table.js';

/** More bodies or manifolds than any world has. */
const MOST = 2 ** 22;

/** Words of a pose, and how many of `saveContacts` stand before the columns: of all, and of a manifold. */
const POSE = 14;
const START = 2;
const HEAD = 2;
const COLUMNS = 33;

const bits = new Int32Array(1);
const seconds = new Float32Array(bits.buffer);

const writer = new DeltaWriter();

/** All in one text: words as they differ from what they are likely to be. */
export function packMoment(moment: Moment, dt: number): string {
  const { ids, placed, poses, contacts, list } = moment;
  seconds[0] = dt;
  const bodies = new BodyTable(ids.length);
  bodies.take(moment);
  const places = new Table(1 + POSE, placed.length);
  places.words.set(placed);
  inRows(new Int32Array(poses.buffer, poses.byteOffset, POSE * placed.length), places);
  const touching = contacts.length > 0 ? contacts[0]! : -1;
  const points = touching < 0 ? undefined : pointsOf(contacts, bodies);
  writer.begin(
    bodies.words.length +
      places.words.length +
      START * contacts.length +
      MOST_HEAD +
      (points?.words.length ?? 0),
  );
  for (const word of [ids.length, placed.length, touching, list, bits[0]!]) writer.put(word);
  writeTable(bodies, bodies.guesses, writer);
  writeTable(places, placesOf(places), writer);
  if (points) writeTable(points.manifolds, points.manifolds.guesses, writer);
  if (points) writeTable(points, points.guesses, writer);
  return pack(writer.end());
}

const MOST_HEAD = 16;

function placesOf(places: Table): (column: number) => ReturnType<typeof goingOn> | Int32Array {
  const before = likeBefore(places.rows);
  return (column) => (column === 0 ? goingOn(places, 0) : before);
}

/** A pose is a row. */
function inRows(words: Int32Array, { words: to, rows }: Table): void {
  for (let row = 0; row < rows; row++)
    for (let k = 0; k < POSE; k++) to[(1 + k) * rows + row] = words[row * POSE + k]!;
}

function pointsOf(contacts: Int32Array, bodies: BodyTable): PointTable {
  const [rows, count] = contacts as unknown as [number, number];
  const manifolds = new ManifoldTable(rows);
  for (let row = 0; row < rows; row++)
    for (let k = 0; k < HEAD; k++)
      manifolds.words[k * rows + row] = contacts[START + HEAD * row + k]!;
  const points = new PointTable(manifolds, bodies.framesBefore(seconds[0]!), bodies.sizes);
  const begins = new Int32Array(COLUMNS);
  const same: boolean[] = [];
  let at = START + HEAD * rows;
  for (let column = 0; column < COLUMNS; column++) {
    same[column] = contacts[at] === 1;
    begins[column] = at + 1;
    at += 1 + (same[column] ? Math.min(1, count) : count);
  }
  points.take(contacts, begins, same);
  return points;
}

/** Throws where it is none. */
export function unpackMoment(text: string): Moment {
  const reader = new DeltaReader(bytesOf(text));
  const [count, placed, touching, list] = [0, 1, 2, 3].map(() => reader.next()) as [
    number,
    number,
    number,
    number,
  ];
  bits[0] = reader.next();
  if (![count, placed, touching + 1].every((number) => number >= 0 && number < MOST))
    throw new RangeError('this is no moment of a world');
  const bodies = new BodyTable(count);
  readTable(bodies, bodies.guesses, reader);
  const places = new Table(1 + POSE, placed);
  readTable(places, placesOf(places), reader);
  const contacts = touching < 0 ? new Int32Array(0) : readContacts(reader, touching, bodies);
  if (!reader.done) throw new RangeError('this is more than a moment of a world');
  return {
    ...bodies.give(),
    placed: [...places.words.subarray(0, placed)],
    poses: posesIn(places),
    contacts,
    list,
  };
}

function posesIn({ words, rows }: Table): Float64Array {
  const poses = new Float64Array((POSE / 2) * rows);
  const to = new Int32Array(poses.buffer);
  for (let row = 0; row < rows; row++)
    for (let k = 0; k < POSE; k++) to[row * POSE + k] = words[(1 + k) * rows + row]!;
  return poses;
}

function readContacts(reader: DeltaReader, rows: number, bodies: BodyTable): Int32Array {
  const manifolds = new ManifoldTable(rows);
  readTable(manifolds, manifolds.guesses, reader);
  const points = new PointTable(manifolds, bodies.framesBefore(seconds[0]!), bodies.sizes);
  readTable(points, points.guesses, reader);
  const first = START + HEAD * rows;
  const contacts = new Int32Array(first + COLUMNS * (1 + points.rows));
  contacts[0] = rows;
  contacts[1] = points.rows;
  for (let row = 0; row < rows; row++)
    for (let k = 0; k < HEAD; k++)
      contacts[START + HEAD * row + k] = manifolds.words[k * rows + row]!;
  points.give(contacts, first);
  return contacts;
}
