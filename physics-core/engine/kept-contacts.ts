import type { Ammo } from './ammo.js';
import { bodyAAt, bodyBAt, pointAt, pointCountAt } from './manifold.js';
import { partsKey } from './manifold-parts.js';
import { BODY, MANIFOLD, MANIFOLD_POINT as POINT, MOST_POINTS } from './offsets.js';

// Contact points as they stand on the heap, to the last bit: Bullet's next step begins with them.

type Visit = (manifold: number, a: number, b: number) => void;

const words = (first: number, count: number): number[] =>
  Array.from({ length: count }, (_, i) => first / 4 + i);

/** Words of a point that are numbers, and that somebody reads; those of friction may be of a fresh point, which nobody wrote. */
const NUMBERS = [
  ...words(POINT.localA, 3),
  ...words(POINT.localB, 3),
  ...words(POINT.positionB, 3),
  ...words(POINT.normalB, 3),
  ...words(POINT.distance, 1),
  ...words(POINT.impulse, 1),
];

/** All that are kept, a column each. Where a point lies on A follows; lifetimes and what is between vectors nobody asks for. */
const COLUMNS = [
  ...NUMBERS,
  ...words(POINT.friction, 9),
  ...words(POINT.lateralImpulse1, 4),
  ...words(POINT.direction1, 3),
  ...words(POINT.direction2, 3),
];

/** A flag of one byte: what lies behind it nobody wrote. */
const FLAG = POINT.directionsGiven / 4;

/** Words of a manifold: the rank of A, and that of B times four with the number of points less one. */
const HEAD = 2;

/** Words at the beginning: how many manifolds and how many points. */
const START = 2;

/** What is kept of all manifolds with points: heads, then column by column, of those that are the same all over one word. */
export function saveContacts({ HEAP32 }: Ammo, each: (visit: Visit) => void): Int32Array {
  const heads: number[] = [];
  const points: number[] = [];
  each((manifold, a, b) => {
    const count = HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!;
    if (count === 0) return;
    const ranks = [a, b].map((body) => HEAP32[(body + BODY.rank) >> 2]!);
    heads.push(ranks[0]!, ranks[1]! * MOST_POINTS + count - 1);
    for (let i = 0; i < count; i++) points.push(pointAt(manifold, i) >> 2);
  });
  const kept = new Int32Array(START + heads.length + COLUMNS.length * (1 + points.length));
  kept[0] = heads.length / HEAD;
  kept[1] = points.length;
  kept.set(heads, START);
  let used = START + heads.length;
  for (const column of COLUMNS) {
    const mask = column === FLAG ? 0xff : -1;
    const first = used++;
    for (let i = 0; i < points.length; i++) kept[used + i] = HEAP32[points[i]! + column]! & mask;
    const same = isSame(kept, used, used + points.length);
    kept[first] = +same;
    used += same ? Math.min(1, points.length) : points.length;
  }
  return kept.slice(0, used);
}

function isSame(numbers: Int32Array, from: number, to: number): boolean {
  for (let i = from + 1; i < to; i++) if (numbers[i] !== numbers[from]) return false;
  return true;
}

/** Where the columns begin, and whether each is one word. Undefined: these are no contacts of so many bodies. */
function columnsOf(
  kept: Int32Array,
  bodies = Infinity,
): { at: number; same: boolean }[] | undefined {
  const [manifolds = -1, points = -1] = kept;
  let at = START + HEAD * manifolds;
  if (manifolds < 0 || points < manifolds || at > kept.length) return undefined;
  let counted = 0;
  for (let i = START; i < at; i += HEAD) {
    const last = kept[i + 1]!;
    if (!(kept[i]! >= 0 && kept[i]! < bodies && last >= 0 && last < MOST_POINTS * bodies))
      return undefined;
    counted += 1 + (last % MOST_POINTS);
  }
  const columns = COLUMNS.map(() => {
    const same = kept[at] === 1;
    const column = { at: at + 1, same };
    at += 1 + (same ? Math.min(1, points) : points);
    return column;
  });
  return counted === points && at === kept.length ? columns : undefined;
}

/** Whether words are contact points of so many bodies. */
export function areContacts(kept: Int32Array, bodies: number): boolean {
  const columns = columnsOf(kept, bodies);
  const floats = new Float32Array(kept.buffer, kept.byteOffset, kept.length);
  return (
    columns !== undefined &&
    NUMBERS.every((_, i) => {
      const { at, same } = columns[i]!;
      const count = same ? Math.min(1, kept[1]!) : kept[1]!;
      return floats.subarray(at, at + count).every(Number.isFinite);
    })
  );
}

/** A manifold, undefined where there is none; its points in `kept`, how many, and the rank of B. */
interface Load {
  manifold: number | undefined;
  first: number;
  count: number;
  b: number;
}

/** Numbers of a column, by the point. */
type Values = (column: number, point: number) => number;

function valuesOf(kept: Int32Array): Values {
  const columns = columnsOf(kept)!;
  return (column, point) => {
    const { at, same } = columns[column]!;
    return kept[same ? at : at + point]!;
  };
}

/**
 * Visits what has no manifold between bodies of several parts: Bullet makes those of two parts only where their boxes
 * overlap as one of the bodies has them, and keeps them for longer. Told is B, and the column of the normal from B into A.
 */
export function eachLost(
  ammo: Ammo,
  each: (visit: Visit) => void,
  kept: Int32Array,
  visit: (rankB: number, normal: readonly [number, number, number]) => void,
): void {
  const value = valuesOf(kept);
  const floats = new Float32Array(kept.buffer, kept.byteOffset, kept.length);
  const columns = columnsOf(kept)!;
  const number = (column: number, point: number): number => {
    const { at, same } = columns[column]!;
    return floats[same ? at : at + point]!;
  };
  for (const { manifold, first, b } of match(ammo, each, kept, value))
    if (manifold === undefined)
      visit(b, [number(NORMAL, first), number(NORMAL + 1, first), number(NORMAL + 2, first)]);
}

/** Into manifolds that Bullet has made of the same pairs; what is near each other otherwise touches nowhere. */
export function loadContacts(ammo: Ammo, each: (visit: Visit) => void, kept: Int32Array): void {
  const value = valuesOf(kept);
  const loads = match(ammo, each, kept, value);
  each((manifold) => (ammo.HEAP32[(manifold + MANIFOLD.pointCount) >> 2] = 0));
  const pointers: number[] = [];
  const numbers: number[] = [];
  for (const { manifold, first, count } of loads) {
    if (manifold === undefined) continue;
    ammo.HEAP32[(manifold + MANIFOLD.pointCount) >> 2] = count;
    for (let i = 0; i < count; i++) {
      pointers.push(pointAt(manifold, i) >> 2);
      numbers.push(first + i);
    }
  }
  const { HEAP32, HEAPF32 } = ammo;
  columnsOf(kept)?.forEach(({ at, same }, column) => {
    const word = COLUMNS[column]!;
    for (let i = 0; i < pointers.length; i++)
      HEAP32[pointers[i]! + word] = kept[same ? at : at + numbers[i]!]!;
  });
  for (const point of pointers) placeOnA(HEAPF32, point);
}

/** Until the next step works it out anew. */
function placeOnA(floats: Float32Array, point: number): void {
  const distance = floats[point + POINT.distance / 4]!;
  for (let k = 0; k < 3; k++)
    floats[point + POINT.positionA / 4 + k] =
      floats[point + POINT.positionB / 4 + k]! + floats[point + POINT.normalB / 4 + k]! * distance;
}

const NORMAL = COLUMNS.indexOf(POINT.normalB / 4);

/** Of A and of B: what a point lies on, and whether that is a triangle, whose number stands there in place of its mesh's. */
const SIDES = [
  [POINT.index0 / 4, POINT.part0 / 4],
  [POINT.index1 / 4, POINT.part1 / 4],
] as const;
const ON_MESH = 2 ** 23;

function match(ammo: Ammo, each: (visit: Visit) => void, kept: Int32Array, value: Values): Load[] {
  const rankOf = (body: number): number => ammo.HEAP32[(body + BODY.rank) >> 2]!;
  const keyOf = (a: number, b: number): number => a * 2 ** 26 + b;
  const found = new Map<number, number[]>();
  each((manifold, a, b) => {
    const key = keyOf(rankOf(a), rankOf(b));
    const those = found.get(key);
    if (those) those.push(manifold);
    else found.set(key, [manifold]);
  });
  const loads: Load[] = [];
  let first = 0;
  for (let i = 0; i < kept[0]!; i++) {
    const at = START + HEAD * i;
    const b = Math.floor(kept[at + 1]! / MOST_POINTS);
    const count = 1 + (kept[at + 1]! % MOST_POINTS);
    const those = found.get(keyOf(kept[at]!, b)) ?? [];
    const manifold = takeOut(ammo, those, (word) => value(COLUMNS.indexOf(word), first));
    loads.push({ manifold, first, count, b });
    first += count;
  }
  return loads;
}

/** Of several of one pair the one of the same parts; of parts that are meshes, whose triangles may be others, the nearest. */
function takeOut(ammo: Ammo, those: number[], said: (word: number) => number): number | undefined {
  const [first] = those;
  if (first === undefined) return undefined;
  const keyOf = (of: typeof said): number => {
    const [a, b] = SIDES.map(([index, part]) => (of(part) < 0 ? of(index) : ON_MESH));
    return partsKey(ammo, bodyAAt(ammo, first), bodyBAt(ammo, first), a!, b!);
  };
  const empty = (manifold: number) => pointCountAt(ammo, manifold) === 0;
  const key = keyOf(said);
  const same = those.filter(
    (manifold) =>
      !empty(manifold) && keyOf((word) => ammo.HEAP32[(pointAt(manifold, 0) >> 2) + word]!) === key,
  );
  const taken = same.length > 1 ? nearest(ammo, same, said) : (same[0] ?? those.find(empty));
  if (taken !== undefined) those.splice(those.indexOf(taken), 1);
  return taken;
}

const bits = new Int32Array(1);
const asFloat = new Float32Array(bits.buffer);

/** Which has a point nearest to the one that was kept, as B carries it. */
function nearest(
  { HEAP32, HEAPF32 }: Ammo,
  those: number[],
  said: (word: number) => number,
): number {
  const kept = words(POINT.localB, 3).map((word) => {
    bits[0] = said(word);
    return asFloat[0]!;
  });
  const distance = (manifold: number): number => {
    let least = Infinity;
    for (let i = 0; i < HEAP32[(manifold + MANIFOLD.pointCount) >> 2]!; i++) {
      const at = (pointAt(manifold, i) + POINT.localB) >> 2;
      const square = kept.reduce((sum, x, k) => sum + (x - HEAPF32[at + k]!) ** 2, 0);
      least = Math.min(least, square);
    }
    return least;
  };
  return those.reduce((best, other) => (distance(other) < distance(best) ? other : best));
}
