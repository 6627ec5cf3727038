import type { Ammo } from './ammo.js';

/** A function of the wasm as JavaScript calls it. */
export type WasmFunction = (...args: number[]) => number;

/** One of ours in a table of virtual functions: `signature` as the glue wants it, result first. */
export interface Override {
  call: (...args: number[]) => void;
  signature: string;
}

/** What the glue has beside its classes. */
interface Glue {
  addFunction(call: Override['call'], signature: string): number;
  /** The exports of the wasm, under names that the build has shortened. */
  readonly asm: Readonly<Record<string, unknown>>;
}

/** Entries before the first function: how far to the object's beginning, and its type. */
const BEFORE = 2;

/** Where the table of an object leads to that has virtual functions: its first word. */
export const tableOf = ({ HEAP32 }: Ammo, object: number): number => HEAP32[object >> 2]!;

/** The functions at these entries of a table. */
export function functionsAt(ammo: Ammo, table: number, entries: readonly number[]): WasmFunction[] {
  const { asm } = ammo as unknown as Glue;
  const all = Object.values(asm).find((each) => each instanceof WebAssembly.Table)!;
  return entries.map((entry) => all.get(ammo.HEAP32[(table >> 2) + entry]!));
}

/** A table of `count` functions like theirs, with ours at some entries. The build has no way to give memory back: to be made once. */
export function tableLike(
  ammo: Ammo,
  theirs: number,
  count: number,
  overrides: Readonly<Record<number, Override>>,
): number {
  const memory = ammo._malloc(4 * (BEFORE + count));
  const ours = (memory >> 2) + BEFORE;
  ammo.HEAP32.copyWithin(memory >> 2, (theirs >> 2) - BEFORE, (theirs >> 2) + count);
  for (const [entry, { call, signature }] of Object.entries(overrides))
    ammo.HEAP32[ours + Number(entry)] = (ammo as unknown as Glue).addFunction(call, signature);
  return 4 * ours;
}
