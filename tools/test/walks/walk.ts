import { BULLET, type Call } from './recorder.js';

/** The rooms that all others speak and reckon with: numbers, values, queues. They know neither world, node nor Bullet. */
const COMMON = ['fields', 'base'];

/** The folder below physics-core; what lies in none is its face. */
export const roomOf = ({ file }: Call): string =>
  file === BULLET ? BULLET : file.includes('/') ? file.split('/')[0]! : 'index';

/**
 * A crossing is a call (of a function, method, accessor, constructor or callback) from one room into another. What lies
 * in `fields` and `base` belongs to whoever calls it: a call into them crosses nothing, and one that they make, as
 * EventQueue.during does, is their caller's.
 */
export const crossings = (calls: readonly Call[]): Call[] =>
  calls.filter((call) => {
    const room = roomOf(call);
    if (room === BULLET || COMMON.includes(room)) return false;
    const caller = callerBeyond(call, COMMON);
    return caller !== undefined && roomOf(caller) !== room;
  });

function callerBeyond({ caller }: Call, rooms: readonly string[]): Call | undefined {
  while (caller && rooms.includes(roomOf(caller))) caller = caller.caller;
  return caller;
}

/** The same with every call into `fields` and `base` and back. */
export const crossingsOfAll = (calls: readonly Call[]): Call[] =>
  calls.filter(
    (call) =>
      roomOf(call) !== BULLET && call.caller !== undefined && roomOf(call.caller) !== roomOf(call),
  );

/** The calls before the first one of this name; all of them, where there is none. */
export function before(calls: readonly Call[], name: string): readonly Call[] {
  const at = calls.findIndex((call) => call.name === name);
  return at < 0 ? calls : calls.slice(0, at);
}

export const named = (calls: readonly Call[], name: string | RegExp): Call[] =>
  calls.filter((call) => (typeof name === 'string' ? call.name === name : name.test(call.name)));

export const inCore = (calls: readonly Call[]): Call[] =>
  calls.filter((call) => roomOf(call) !== BULLET);

export const filesOf = (calls: readonly Call[]): string[] => [
  ...new Set(inCore(calls).map(({ file }) => file)),
];

/** How often each file of a folder is called, in the order of their first calls. */
export function callsByFile(calls: readonly Call[], folder: string): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { file } of calls)
    if (file.startsWith(folder)) counts.set(file, (counts.get(file) ?? 0) + 1);
  return counts;
}

/** How the names of functions begin that change something. */
const CHANGES =
  /(^|\.)#?(set|add|remove|make|need|release|apply|update|replace|take|fill|place|attach|detach|enter|leave|configure|force|clear)/;

/** Calls that change something, on the same object and with the same arguments as one before: work done twice. */
export function doneTwice(calls: readonly Call[]): Call[] {
  const earlier: Call[] = [];
  return calls.filter((call) => {
    if (!CHANGES.test(call.name) || call.on === undefined) return false;
    const twice = earlier.some((one) => isSame(one, call));
    earlier.push(call);
    return twice;
  });
}

function isSame(a: Call, b: Call): boolean {
  const [one, two] = [Array.from(a.with ?? []), Array.from(b.with ?? [])];
  return (
    a.file === b.file &&
    a.name === b.name &&
    a.on === b.on &&
    one.length === two.length &&
    one.every((value, i) => value === two[i])
  );
}

export const describe = ({ file, name }: Call): string => `${file} ${name}`;
