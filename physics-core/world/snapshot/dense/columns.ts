import { cloned, type Column } from '../snapshot.js';
import { bytesOf, doublesOf, pack } from '../../../base/packed.js';

/** Longer lists are kept as they are. */
const MOST_PARTS = 16;

/** Fewer numbers are kept as they are; few are as many as a byte can tell apart, and a share of all. */
const LEAST_PACKED = 8;
const FEW = 256;
const FEW_SHARE = 1 / 4;

const isPlain = (value: unknown): value is object =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;

export function columnOf(values: readonly unknown[]): Column {
  const first = values[0] ?? null;
  if (typeof first !== 'object' || first === null) {
    if (values.every((value) => value === values[0])) return { all: first };
    const numbers = values.every((value) => typeof value === 'number');
    return numbers ? numbersOf(values as number[]) : { each: values.map(cloned) };
  }
  const { length } = first as unknown[];
  if (Array.isArray(first)) {
    const alike = (value: unknown) => Array.isArray(value) && value.length === length;
    if (length <= MOST_PARTS && values.every(alike))
      return { parts: first.map((_, part) => partOf(values, part)) };
  } else if (isPlain(first)) {
    const names = Object.keys(first);
    const alike = (value: unknown) =>
      isPlain(value) && String(Object.keys(value)) === String(names);
    if (values.every(alike))
      return { named: Object.fromEntries(names.map((name) => [name, partOf(values, name)])) };
  }
  return { each: values.map(cloned) };
}

const partOf = (values: readonly unknown[], name: string | number): Column =>
  columnOf(values.map((value) => (value as Record<string | number, unknown>)[name]));

function numbersOf(values: readonly number[]): Column {
  const { length } = values;
  if (length < LEAST_PACKED) return { each: [...values] };
  const most = Math.min(FEW, length * FEW_SHARE);
  const few = new Map<number, number>();
  const which = new Uint8Array(length);
  for (let i = 0; i < length && few.size <= most; i++) {
    let number = few.get(values[i]!);
    if (number === undefined) few.set(values[i]!, (number = few.size));
    which[i] = number;
  }
  return few.size > most
    ? pack(Float64Array.from(values))
    : { few: [...few.keys()], which: pack(which) };
}

/** As many values; throws where there are more or fewer. */
export function valuesIn(column: Column, count: number): unknown[] {
  const values = allIn(column, count);
  if (values.length !== count) throw new RangeError('values are missing');
  return values;
}

function allIn(column: Column, count: number): unknown[] {
  const rows = { length: count };
  if (typeof column === 'string') return [...doublesOf(column)];
  if ('parts' in column) {
    const parts = column.parts.map((part) => valuesIn(part, count));
    return Array.from(rows, (_, i) => parts.map((part) => part[i]));
  }
  if ('named' in column) {
    const named = Object.entries(column.named).map(
      ([name, part]) => [name, valuesIn(part, count)] as const,
    );
    return Array.from(rows, (_, i) =>
      Object.fromEntries(named.map(([name, part]) => [name, part[i]])),
    );
  }
  if ('few' in column) return Array.from(bytesOf(column.which), (number) => column.few[number]);
  return 'each' in column ? cloned(column.each) : Array.from(rows, () => column.all);
}
