import type { FieldType, Value } from './types.js';

/** How one field type reads text, takes JavaScript values, compares and prints. `undefined` means malformed. */
export interface FieldCodec {
  /** X3D text (numbers parted by spaces or commas) to a value. */
  parse(text: string): Value | undefined;
  /** Anything a property or `set` may be given: the value itself, a typed array, or the text. */
  accept(value: unknown): Value | undefined;
  equal(a: Value, b: Value): boolean;
  /** A fresh copy, so that nobody holds our own arrays. */
  copy(value: Value): Value;
  format(value: Value): string;
}

const SEPARATOR = /[\s,]+/;

function numbersIn(text: string): number[] | undefined {
  const trimmed = text.trim();
  if (trimmed === '') return [];
  const numbers: number[] = [];
  for (const part of trimmed.split(SEPARATOR)) {
    if (part === '') continue;
    const number = Number(part);
    if (!Number.isFinite(number)) return undefined;
    numbers.push(number);
  }
  return numbers;
}

function isNumberList(value: unknown): value is ArrayLike<number> {
  return Array.isArray(value) || ArrayBuffer.isView(value);
}

function finiteNumbers(value: unknown): number[] | undefined {
  if (typeof value === 'string') return numbersIn(value);
  if (!isNumberList(value)) return undefined;
  const items = Array.from(value as ArrayLike<unknown>);
  // Seldom lists in a list: to look first takes a twentieth of the time.
  const numbers = items.some(isNumberList)
    ? items.flatMap((item) => (isNumberList(item) ? Array.from(item) : item))
    : items;
  return numbers.every(Number.isFinite) ? (numbers as number[]) : undefined;
}

function sameList(a: Value, b: Value): boolean {
  const left = a as unknown[];
  const right = b as unknown[];
  return left.length === right.length && left.every((item, index) => item === right[index]);
}

const copyList = (value: Value): Value => [...(value as unknown[])];

function tuple(length: number): FieldCodec {
  const exactly = (numbers: number[] | undefined): number[] | undefined =>
    numbers?.length === length ? numbers : undefined;
  return {
    parse: (text) => exactly(numbersIn(text)),
    accept: (value) => exactly(finiteNumbers(value)),
    equal: sameList,
    copy: copyList,
    format: (value) => (value as number[]).join(' '),
  };
}

function scalar(check: (number: number) => boolean): FieldCodec {
  const only = (number: number): number | undefined =>
    Number.isFinite(number) && check(number) ? number : undefined;
  const parse = (text: string): number | undefined =>
    text.trim() === '' ? undefined : only(Number(text));
  return {
    parse,
    accept: (value) =>
      typeof value === 'number'
        ? only(value)
        : typeof value === 'string'
          ? parse(value)
          : undefined,
    equal: Object.is,
    copy: (value) => value,
    format: String,
  };
}

const numberList: FieldCodec = {
  parse: numbersIn,
  accept: finiteNumbers,
  equal: sameList,
  copy: copyList,
  format: (value) => (value as number[]).join(' '),
};

function triples(numbers: number[] | undefined): number[][] | undefined {
  if (!numbers || numbers.length % 3 !== 0) return undefined;
  const list: number[][] = [];
  for (let i = 0; i < numbers.length; i += 3) list.push(numbers.slice(i, i + 3));
  return list;
}

/** What X3D calls an integer has 32 bits. */
const isInt32 = (number: number): boolean => (number | 0) === number;

const integers = (numbers: number[] | undefined): number[] | undefined =>
  numbers?.every(isInt32) ? numbers : undefined;

const integerList: FieldCodec = {
  ...numberList,
  parse: (text) => integers(numbersIn(text)),
  accept: (value) => integers(finiteNumbers(value)),
};

const vec3List: FieldCodec = {
  parse: (text) => triples(numbersIn(text)),
  accept: (value) => triples(finiteNumbers(value)),
  equal: (a, b) => sameList((a as number[][]).flat(), (b as number[][]).flat()),
  copy: (value) => (value as number[][]).map((item) => [...item]),
  format: (value) => (value as number[][]).map((item) => item.join(' ')).join(', '),
};

/** A bare attribute (`fixed`) means true, as everywhere in HTML. */
function parseBool(text: string): boolean | undefined {
  const word = text.trim().toLowerCase();
  if (word === 'true' || word === '') return true;
  return word === 'false' ? false : undefined;
}

const bool: FieldCodec = {
  parse: parseBool,
  accept: (value) =>
    typeof value === 'boolean' ? value : typeof value === 'string' ? parseBool(value) : undefined,
  equal: Object.is,
  copy: (value) => value,
  format: String,
};

const string: FieldCodec = {
  parse: (text) => text,
  accept: (value) => (typeof value === 'string' ? value : undefined),
  equal: Object.is,
  copy: (value) => value,
  format: String,
};

/** `"BOUNCE" "SPEED-1"`; words without quotes are taken one by one. */
function parseStrings(text: string): string[] {
  const words = text.match(/"(?:[^"\\]|\\.)*"|[^\s,"]+/g) ?? [];
  return words.map((word) =>
    word.startsWith('"') ? word.slice(1, -1).replace(/\\(["\\])/g, '$1') : word,
  );
}

const stringList: FieldCodec = {
  parse: parseStrings,
  accept: (value) => {
    if (typeof value === 'string') return parseStrings(value);
    return Array.isArray(value) && value.every((item) => typeof item === 'string')
      ? [...value]
      : undefined;
  },
  equal: sameList,
  copy: copyList,
  format: (value) => (value as string[]).map((item) => JSON.stringify(item)).join(' '),
};

const isNode = (value: unknown): value is object =>
  typeof value === 'object' && value !== null && !ArrayBuffer.isView(value);

/** A node, or a list of one. */
function oneNode(value: unknown): Value | undefined {
  if (!Array.isArray(value)) return value === null || isNode(value) ? value : undefined;
  return value.length > 1 ? undefined : value.length === 0 ? null : oneNode(value[0]);
}

/** One and the same node, or plain data that say the same. */
function sameNode(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((item, i) => sameNode(item, b[i]));
  if (!isPlain(a) || !isPlain(b)) return false;
  const names = Object.keys(a);
  return (
    names.length === Object.keys(b).length && names.every((name) => sameNode(a[name], b[name]))
  );
}

const isPlain = (value: unknown): value is Record<string, unknown> =>
  isNode(value) && Object.getPrototypeOf(value) === Object.prototype;

const node: FieldCodec = {
  parse: () => undefined,
  accept: oneNode,
  equal: sameNode,
  copy: (value) => value,
  format: String,
};

const nodeList: FieldCodec = {
  parse: (text) => (text.trim() === '*' ? '*' : undefined),
  accept: (value) =>
    value === '*' || Array.isArray(value) ? value : isNode(value) ? [value] : undefined,
  equal: sameNode,
  copy: (value) => (Array.isArray(value) ? [...value] : value),
  format: String,
};

export const codecs: Record<FieldType, FieldCodec> = {
  SFBool: bool,
  SFFloat: scalar(() => true),
  SFInt32: scalar(isInt32),
  SFTime: scalar(() => true),
  SFString: string,
  SFVec2f: tuple(2),
  SFVec3f: tuple(3),
  SFRotation: tuple(4),
  SFMatrix3f: tuple(9),
  MFFloat: numberList,
  MFInt32: integerList,
  MFString: stringList,
  MFVec3f: vec3List,
  SFNode: node,
  MFNode: nodeList,
};
