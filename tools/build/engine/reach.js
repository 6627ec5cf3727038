// Which functions of a module that was compiled from C++ can ever run: what its exports lead to.
//
// - Who is called by name is reached with its caller.
// - A virtual function is reached if a table that it stands in is in use, and somebody reached calls that slot of an object,
//   with numbers of its type. A table is in use where its address stands in a function that is reached, as in every
//   constructor, or in the data.
// - Any other function whose address the program takes is reached if its number stands in the data outside such tables, or
//   in a function that is reached, whatever it may mean there, and somebody reached calls its type by number.
//
// C++ takes the address of no virtual function but through its table. So a number that stands in one is nothing else: 1024
// bytes are no soft body. Of which kind an object is, which stands before its table, counts where the address of that kind
// stands in a function that is reached, or where such a function may read what stands there.
//
// That says too much where two kinds have slots of one type: what nobody calls all the same stands in `never.js`.
import binaryen from 'binaryen';
import { functionsOf, slotOf } from './bodies.js';
import {
  addressesOf,
  kindsOf,
  numbersOf,
  slotAt,
  spansOfKind,
  spansOfTable,
  virtualTables,
  wordsOf,
} from './data.js';
import { isCalled, isMade } from './never.js';

/** Names of the functions that exports stand for. */
function exported(module) {
  const names = [];
  for (let i = 0; i < module.getNumExports(); i++) {
    const { kind, value } = binaryen.getExportInfo(module.getExportByIndex(i));
    if (kind === binaryen.ExternalFunction) names.push(value);
  }
  return names;
}

/** By their addresses. */
const byAddress = (things) =>
  new Map(things.flatMap((thing) => addressesOf(thing).map((address) => [address, thing])));

class Reach {
  /** Names of the functions. */
  names = new Set();
  #functions;
  /** Names by the numbers that they are called by. */
  #byNumber;
  #words;
  #tables;
  /** Numbers of virtual functions. */
  #virtual;
  /** The table that a word belongs to. */
  #tableAt;
  /** Kinds of objects by their addresses. */
  #kinds;
  /** Tables and kinds in use. */
  #used = new Set();
  /** Of some tables, the slot from which on all functions count. */
  #from = new Map();
  /** Numbers of functions whose address is taken. */
  #taken = new Set();
  /** What is called by number: see `bodies.js`. */
  #types = new Set();
  #slots = new Set();
  #anySlot = new Set();
  #readsHeads = false;

  constructor(module) {
    this.#functions = functionsOf(module);
    this.#byNumber = numbersOf(module);
    this.#words = wordsOf(module);
    this.#tables = virtualTables(this.#words, (number) => this.#byNumber.has(number));
    this.#virtual = new Set(this.#tables.flatMap(({ slots }) => slots));
    this.#tableAt = byAddress(this.#tables);
    this.#kinds = new Map(kindsOf(this.#words).map((kind) => [kind.first, kind]));
    const ofKinds = byAddress([...this.#kinds.values()]);
    for (const [address, word] of this.#words)
      if (!this.#tableAt.has(address) && !ofKinds.has(address)) this.#see(word);
    for (const name of exported(module)) this.#add(name);
    this.#close();
  }

  /** What nothing can read: kinds, with their names, and slots that nobody calls. Addresses, and how many bytes from there. */
  get unread() {
    const kinds = [...this.#kinds.values()].filter((kind) => !this.#used.has(kind));
    const isCut = (number) => !this.names.has(this.#byNumber.get(number));
    return [
      ...kinds.flatMap(spansOfKind),
      ...this.#tables.flatMap((table) => spansOfTable(table, isCut)),
    ];
  }

  /** A number stands somewhere: it may be an address of data, or of a function. */
  #see(number) {
    this.#seeTable(number);
    const kind = this.#kinds.get(number);
    if (kind) this.#used.add(kind);
    if (this.#byNumber.has(number) && !this.#virtual.has(number)) this.#taken.add(number);
  }

  #seeTable(address) {
    const table = this.#tableAt.get(address);
    if (!table || !isMade(table.name)) return;
    this.#used.add(table);
    this.#seeWithin(table, address);
  }

  /** No object is told of its table so, but a list that lies behind one may be read. */
  #seeOffset(address) {
    const table = this.#tableAt.get(address);
    if (table && slotAt(table, address) > 0) this.#seeTable(address);
  }

  /** What a place within a table is used for, nobody knows: it counts as used from there to the end. */
  #seeWithin(table, address) {
    const slot = slotAt(table, address);
    if (slot > 0) this.#from.set(table, Math.min(slot, this.#from.get(table) ?? Infinity));
  }

  #add(name) {
    if (this.names.has(name)) return;
    this.names.add(name);
    const { body } = this.#functions.get(name);
    if (!body) return;
    for (const number of body.numbers) this.#see(number);
    for (const offset of body.offsets) this.#seeOffset(offset);
    for (const type of body.types) this.#types.add(type);
    for (const slot of body.slots) this.#slots.add(slot);
    for (const type of body.anySlot) this.#anySlot.add(type);
    this.#readsHeads ||= body.readsHeads;
    for (const callee of body.calls) this.#add(callee);
  }

  /** Until nothing leads to anything new. */
  #close() {
    let before;
    do {
      before = this.names.size;
      if (this.#readsHeads) this.#useKinds();
      for (const number of this.#taken) this.#addIf(number, ({ type }) => this.#types.has(type));
      for (const table of this.#tables.filter((each) => this.#used.has(each))) {
        for (const [slot, number] of table.slots.entries())
          if (isCalled(table.name, slot))
            this.#addIf(
              number,
              ({ type }) => slot >= this.#from.get(table) || this.#isCalled(type, slot),
            );
      }
    } while (this.names.size > before);
  }

  /** Who asks what an object is asks all kinds, by functions of their own. */
  #useKinds() {
    for (const kind of this.#kinds.values()) {
      this.#used.add(kind);
      for (const address of addressesOf(kind)) this.#see(this.#words.get(address));
    }
  }

  #addIf(number, isReached) {
    const name = this.#byNumber.get(number);
    if (isReached(this.#functions.get(name))) this.#add(name);
  }

  #isCalled(type, slot) {
    return this.#anySlot.has(type) || this.#slots.has(slotOf(type, slot));
  }
}

/** Their names, and which bytes of the data none of them can read. */
export function reached(module) {
  const { names, unread } = new Reach(module);
  return { names, unread };
}
