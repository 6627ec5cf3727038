// What a module that was compiled from C++ begins with: numbers of functions, words of data, and the tables of virtual
// functions among these.
import { Buffer } from 'node:buffer';
import binaryen from 'binaryen';

/** Bytes of an address, and of a number of a function. */
export const WORD = 4;

/** Words of a table before its first function (Itanium ABI): how far it is to the object's beginning, and the object's kind. */
const HEAD = 2;

/** No part of an object that has a table of its own lies so many bytes behind the object's beginning. */
const FARTHEST = 4096;

/** Kinds that another one is derived from. */
const MOST_BASES = 16;

/** What names begin with of those that know how kinds are to be read: kinds begin with the address of such a one's table. */
const RUNTIME = 'N10__cxxabiv1';

/** The module's only list of functions that are called by number. */
export const listOf = (module) =>
  binaryen.getElementSegmentInfo(module.getElementSegmentByIndex(0));

/** Number 0 is no function: the list begins with 1. */
export const FIRST = 1;

/** Names of functions by number. */
export const numbersOf = (module) =>
  new Map(listOf(module).data.map((name, i) => [FIRST + i, name]));

function segmentsOf(module) {
  const segments = [];
  for (let i = 0; i < module.getNumDataSegments(); i++)
    segments.push(module.getDataSegmentInfo(module.getDataSegmentByIndex(i)));
  return segments;
}

/** Words by their addresses. */
export function wordsOf(module) {
  const segments = segmentsOf(module);
  const size = Math.max(...segments.map(({ offset, data }) => offset + data.byteLength));
  const bytes = new Uint8Array(size + WORD);
  for (const { offset, data } of segments) bytes.set(new Uint8Array(data), offset);
  const view = new DataView(bytes.buffer);
  const words = new Map();
  for (let address = 0; address < size; address += WORD)
    words.set(address, view.getInt32(address, true));
  return words;
}

/**
 * Tables of virtual functions, up to the first word that is none: the address that objects have, numbers of functions, and
 * the address and the name of the objects' kind.
 */
export function virtualTables(words, isFunction) {
  const tables = [];
  for (const begin of words.keys()) {
    if (!hasHead(words, begin)) continue;
    const slots = [];
    for (let at = begin; isFunction(words.get(at)); at += WORD) slots.push(words.get(at));
    const kind = words.get(begin - WORD);
    if (slots.length > 0) tables.push({ begin, slots, kind, name: nameOf(words, kind) });
  }
  return tables;
}

const byteAt = (words, address) =>
  (words.get(address - (address % WORD)) >> (8 * (address % WORD))) & 0xff;

/** A text up to its end, a byte of 0. */
function textAt(words, address) {
  let text = '';
  for (let at = address; at > 0 && byteAt(words, at); at++)
    text += String.fromCharCode(byteAt(words, at));
  return text;
}

/** Its second word leads to its name. */
const nameOf = (words, kind) => textAt(words, words.get(kind + WORD));

/** Its first word alone does not tell: behind another such address the data has 0.02, which contacts are kept by. */
const isKind = (words, address) =>
  /^\w+$/.test(nameOf(words, address)) &&
  nameOf(words, words.get(words.get(address) - WORD)).startsWith(RUNTIME);

function hasHead(words, begin) {
  const toBeginning = words.get(begin - HEAD * WORD);
  return toBeginning <= 0 && toBeginning > -FARTHEST && isKind(words, words.get(begin - WORD));
}

/**
 * What a program knows of the kinds of its objects while it runs: a word that says how to read the others, the address of a
 * name, and those kinds that this one is derived from.
 */
export function kindsOf(words) {
  const addresses = new Set([...words.keys()].filter((address) => isKind(words, address)));
  return [...addresses].map((first) => {
    let count = 2;
    while (addresses.has(words.get(first + WORD * count))) count++;
    // Of several: how they are arranged, how many there are, and beside each where it lies in the object.
    const many = words.get(first + WORD * 3);
    if (addresses.has(words.get(first + WORD * 4)) && many < MOST_BASES) count = 4 + 2 * many;
    return { first, count, name: words.get(first + WORD), length: nameOf(words, first).length };
  });
}

/** Addresses of the words of a table or a kind. */
export const addressesOf = ({
  begin,
  slots = [],
  first = begin - HEAD * WORD,
  count = HEAD + slots.length,
}) => Array.from({ length: count }, (_, i) => first + WORD * i);

/** Which slot lies at an address: below 0 in the head. */
export const slotAt = ({ begin }, address) => (address - begin) / WORD;

export const spansOfKind = ({ first, count, name, length }) => [
  [first, WORD * count],
  [name, length],
];

/** Of those slots whose number is cut. */
export const spansOfTable = ({ begin, slots }, isCut) =>
  slots.flatMap((number, slot) => (isCut(number) ? [[begin + WORD * slot, WORD]] : []));

/** The wasm with these of its bytes 0: each from an address on, so many. */
export function without(wasm, module, spans) {
  const bytes = Buffer.from(wasm);
  let before = bytes.length;
  for (const { offset, data } of segmentsOf(module).toReversed()) {
    // Segments are the last of a module, one after the other, as they are.
    before = bytes.lastIndexOf(Buffer.from(data), before);
    if (before < 0)
      throw new Error('tools/build/engine/data.js does not find the data of ammo.wasm');
    for (const [address, length] of spans) {
      const from = Math.max(address - offset, 0);
      const to = Math.min(address - offset + length, data.byteLength);
      if (from < to) bytes.fill(0, before + from, before + to);
    }
  }
  return bytes;
}
