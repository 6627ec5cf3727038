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
// bytes are no soft body.
import binaryen from 'binaryen';
import { functionsOf, slotOf } from './bodies.js';
import { numbersOf, tableFinder, virtualTables, wordsOf } from './data.js';

/** Names of the functions that exports stand for. */
function exported(module) {
  const names = [];
  for (let i = 0; i < module.getNumExports(); i++) {
    const { kind, value } = binaryen.getExportInfo(module.getExportByIndex(i));
    if (kind === binaryen.ExternalFunction) names.push(value);
  }
  return names;
}

class Reach {
  /** Names of the functions. */
  names = new Set();
  #functions;
  /** Names by the numbers that they are called by. */
  #byNumber;
  /** Numbers of virtual functions. */
  #virtual;
  /** The table that an address lies in. */
  #tableAt;
  /** Tables in use. Of the last ones, addresses within them are used, too: all their functions count. */
  #tables = new Set();
  #whole = new Set();
  /** Numbers of functions whose address is taken. */
  #taken = new Set();
  /** What is called by number: see `bodies.js`. */
  #types = new Set();
  #slots = new Set();
  #anySlot = new Set();

  constructor(module) {
    this.#functions = functionsOf(module);
    this.#byNumber = numbersOf(module);
    const words = wordsOf(module);
    const tables = virtualTables(words, (number) => this.#byNumber.has(number));
    this.#virtual = new Set(tables.flatMap(({ slots }) => slots));
    this.#tableAt = tableFinder(tables);
    for (const [address, word] of words) if (!this.#tableAt(address)) this.#see(word);
    for (const name of exported(module)) this.#add(name);
    this.#close();
  }

  /** A number stands somewhere: it may be an address of data, or of a function. */
  #see(number) {
    const table = this.#tableAt(number);
    if (table) this.#tables.add(table);
    if (table && number !== table.begin) this.#whole.add(table);
    if (this.#byNumber.has(number) && !this.#virtual.has(number)) this.#taken.add(number);
  }

  #add(name) {
    if (this.names.has(name)) return;
    this.names.add(name);
    const { body } = this.#functions.get(name);
    if (!body) return;
    for (const number of body.numbers) this.#see(number);
    for (const type of body.types) this.#types.add(type);
    for (const slot of body.slots) this.#slots.add(slot);
    for (const type of body.anySlot) this.#anySlot.add(type);
    for (const callee of body.calls) this.#add(callee);
  }

  /** Until nothing leads to anything new. */
  #close() {
    let before;
    do {
      before = this.names.size;
      for (const number of this.#taken)
        this.#addIf(number, ({ type }) => this.#types.has(type));
      for (const table of this.#tables)
        for (const [slot, number] of table.slots.entries())
          this.#addIf(number, ({ type }) => this.#whole.has(table) || this.#isCalled(type, slot));
    } while (this.names.size > before);
  }

  #addIf(number, isReached) {
    const name = this.#byNumber.get(number);
    if (isReached(this.#functions.get(name))) this.#add(name);
  }

  #isCalled(type, slot) {
    return this.#anySlot.has(type) || this.#slots.has(slotOf(type, slot));
  }
}

/** Their names. */
export const reached = (module) => new Reach(module).names;
