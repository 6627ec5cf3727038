// What the bodies of a module's functions say: whom they call, by name and by number, and which numbers stand in them.
import binaryen from 'binaryen';

const { NopId, UnreachableId, ConstId, CallId, CallIndirectId, LoadId, StoreId } = binaryen;
const { LocalGetId, LocalSetId, BinaryId, SubInt32 } = binaryen;

/** Where an expression has other expressions, whichever it is. */
const PARTS = [
  ...['children', 'operands', 'body', 'condition', 'ifTrue', 'ifFalse', 'value', 'left', 'right'],
  ...['ptr', 'target', 'delta', 'dest', 'source', 'size'],
];

/** Whose parts these are. Another release of Ammo may have others: better no build than one that does not see them. */
const KNOWN = new Set(
  [
    ...['Block', 'If', 'Loop', 'Break', 'Switch', 'Call', 'CallIndirect', 'LocalGet', 'LocalSet'],
    ...['GlobalGet', 'GlobalSet', 'Load', 'Store', 'Const', 'Unary', 'Binary', 'Select', 'Drop'],
    ...['Return', 'MemorySize', 'MemoryGrow', 'MemoryCopy', 'MemoryFill', 'Nop', 'Unreachable'],
  ].map((kind) => binaryen[`${kind}Id`]),
);

/** Bytes of a number of a function. */
const WORD = 4;

const ANY_SLOT = -1;

/** Bytes from where objects lead to the words before: see `data.js`. */
const HEADS = [-4, -8];

/** What a function takes and answers: a call by number reaches those of its own type alone. */
export const typeOf = ({ params, results }) => `${params}>${results}`;

/** A place in tables of virtual functions, for calls of one type. */
export const slotOf = (type, slot) => `${type} ${slot}`;

function infoOf(expression) {
  const id = binaryen.getExpressionId(expression);
  if (!KNOWN.has(id))
    throw new Error(`tools/build/engine/bodies.js does not know expression ${id} of Binaryen`);
  // These have nothing to tell, and Binaryen fails if asked.
  return id === NopId || id === UnreachableId ? { id } : binaryen.getExpressionInfo(expression);
}

/** A call names its function, where others have an expression; 0 is none. */
const partsOf = (info) =>
  info.id === ConstId
    ? []
    : PARTS.flatMap((name) => info[name] ?? []).filter((part) => typeof part === 'number' && part);

class Body {
  /** Names of functions that it calls. */
  calls = new Set();
  /** Numbers that stand in it. */
  numbers = new Set();
  /** Those that it adds to addresses. */
  offsets = new Set();
  /** Types of what it calls by number. */
  types = new Set();
  /** Of these, what it calls by the number that stands in a slot of a table to which an object leads. */
  slots = new Set();
  /** Types of what it may call by the number in any such slot. */
  anySlot = new Set();
  /** Whether it may read what stands in such a table before its functions: what an object is. */
  readsHeads = false;
  #parameters;
  /** What each variable is given. */
  #given = new Map();
  #calledByNumber = [];
  /** Reckoned addresses. */
  #pointers = [];

  constructor({ params, body }) {
    this.#parameters = binaryen.expandType(params).length;
    this.#read(body);
    for (const call of this.#calledByNumber) this.#noteTarget(call);
    this.readsHeads = this.#pointers.some((pointer) => this.#isHead(pointer));
  }

  #read(expression) {
    const info = infoOf(expression);
    const { id } = info;
    if (id === ConstId) this.#noteNumber(info);
    else if (id === LoadId || id === StoreId) this.#noteAddress(info);
    else if (id === CallId) this.calls.add(info.target);
    else if (id === CallIndirectId) this.#calledByNumber.push(info);
    else if (id === LocalSetId) this.#sourcesOf(info.index).push(info.value);
    for (const part of partsOf(info)) this.#read(part);
  }

  #sourcesOf(variable) {
    if (!this.#given.has(variable)) this.#given.set(variable, []);
    return this.#given.get(variable);
  }

  #noteNumber({ type, value }) {
    if (type === binaryen.i32) this.numbers.add(value);
    if (type !== binaryen.i64) return;
    // It may be two words that are written at once.
    for (const shift of [0n, 32n])
      this.numbers.add(Number(BigInt.asIntN(32, BigInt(value) >> shift)));
  }

  #noteAddress({ offset, ptr }) {
    const { id, value } = infoOf(ptr);
    if (id === ConstId) this.numbers.add(offset + value);
    else this.offsets.add(offset);
    if (id === BinaryId) this.#pointers.push(ptr);
  }

  /** `load(load(object) - 4)` */
  #isHead(pointer) {
    const { op, left, right } = infoOf(pointer);
    const { id, value } = infoOf(right);
    const from = infoOf(left);
    const isRead = from.id === LocalSetId ? infoOf(from.value).id === LoadId : this.#isRead(from);
    return isRead && id === ConstId && HEADS.includes(op === SubInt32 ? -value : value);
  }

  #noteTarget({ target, ...call }) {
    const type = typeOf(call);
    this.types.add(type);
    for (const slot of this.#slotsOf(target))
      if (slot === ANY_SLOT) this.anySlot.add(type);
      else this.slots.add(slotOf(type, slot));
  }

  /**
   * The slot of `load(load(object) + 4 slot)`: an object begins with the address of its table. None where the number is read
   * from an address that stands there: what is ever written to that stands in a function, too, or in the data.
   */
  #slotsOf(target) {
    const { id, index, bytes, offset, ptr } = infoOf(target);
    if (id === LocalGetId && this.#isRead({ id, index }))
      return this.#sourcesOf(index).flatMap((source) => this.#slotsOf(source));
    if (id !== LoadId || bytes !== WORD) return [ANY_SLOT];
    const from = infoOf(ptr);
    if (from.id === ConstId) return [];
    return this.#isRead(from) && offset % WORD === 0 ? [offset / WORD] : [ANY_SLOT];
  }

  /** Whether it is as it was read from memory, or a variable that is given nothing else. What a parameter is, others say. */
  #isRead({ id, index }) {
    if (id !== LocalGetId) return id === LoadId;
    const sources = index < this.#parameters ? [] : this.#sourcesOf(index);
    return sources.length > 0 && sources.every((source) => infoOf(source).id === LoadId);
  }
}

/** The functions of a module by their names: each one's type, and what it says where its body is not another module's. */
export function functionsOf(module) {
  const all = new Map();
  for (let i = 0; i < module.getNumFunctions(); i++) {
    const info = binaryen.getFunctionInfo(module.getFunctionByIndex(i));
    all.set(info.name, { type: typeOf(info), body: info.body ? new Body(info) : undefined });
  }
  return all;
}
