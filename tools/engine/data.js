// What a module that was compiled from C++ begins with: numbers of functions, words of data, and the tables of virtual
// functions among these.
import binaryen from 'binaryen';

/** Bytes of an address, and of a number of a function. */
const WORD = 4;

/** Words of a table before its first function (Itanium ABI): how far it is to the object's beginning, and the object's type. */
const HEAD = 2;

/** No part of an object that has a table of its own lies so many bytes behind the object's beginning. */
const FARTHEST = 4096;

/** What a type's name begins with, as compilers write it: its length, or that it is nested or local. */
const NAME = /[1-9NZ]/;

/** The module's only list of functions that are called by number. */
export const listOf = (module) =>
  binaryen.getElementSegmentInfo(module.getElementSegmentByIndex(0));

/** Number 0 is no function: the list begins with 1. */
export const FIRST = 1;

/** Names of functions by number. */
export const numbersOf = (module) =>
  new Map(listOf(module).data.map((name, i) => [FIRST + i, name]));

/** Words by their addresses. */
export function wordsOf(module) {
  const segments = [];
  for (let i = 0; i < module.getNumDataSegments(); i++)
    segments.push(module.getDataSegmentInfo(module.getDataSegmentByIndex(i)));
  const size = Math.max(...segments.map(({ offset, data }) => offset + data.byteLength));
  const bytes = new Uint8Array(size + WORD);
  for (const { offset, data } of segments) bytes.set(new Uint8Array(data), offset);
  const view = new DataView(bytes.buffer);
  const words = new Map();
  for (let address = 0; address < size; address += WORD)
    words.set(address, view.getInt32(address, true));
  return words;
}

/** Tables of virtual functions, up to the first word that is none: the address that objects have, and numbers of functions. */
export function virtualTables(words, isFunction) {
  const tables = [];
  for (const begin of words.keys()) {
    const slots = [];
    if (!hasHead(words, begin)) continue;
    for (let at = begin; isFunction(words.get(at)); at += WORD) slots.push(words.get(at));
    if (slots.length > 0) tables.push({ begin, slots });
  }
  return tables;
}

/** A type's second word leads to its name: that tells such a head from other numbers. */
function hasHead(words, begin) {
  const toBeginning = words.get(begin - HEAD * WORD);
  const type = words.get(begin - WORD);
  if (!(toBeginning <= 0 && toBeginning > -FARTHEST) || !words.has(type)) return false;
  const name = words.get(type + WORD);
  const around = words.get(name - (name % WORD));
  return around !== undefined && NAME.test(String.fromCharCode((around >> (8 * (name % WORD))) & 0xff));
}

/** Which table an address lies in, its head included. */
export function tableFinder(tables) {
  const at = new Map();
  for (const table of tables)
    for (let i = -HEAD; i < table.slots.length; i++) at.set(table.begin + WORD * i, table);
  return (address) => at.get(address);
}
