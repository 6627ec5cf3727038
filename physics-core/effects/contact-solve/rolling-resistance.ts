import { grown, grownInt } from '../../base/grown.js';
import { doublesOf, pack } from '../../base/packed.js';
import type { Numbered } from '../effect/effect.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { islandAt } from '../../engine/heap.js';
import { speedSquared } from '../../engine/solver-body.js';
import { R, type BoundRows } from '../../solver/rows/bound-rows.js';
import { C, type ConeContacts } from '../../solver/rows/cone-contacts.js';
import type { Part } from '../../solver/part.js';
import type { TouchingBodies } from './touching-bodies.js';

/** Bodies of an island that touch something, from which on it is a heap. */
const HEAP = 24;

/** Arm of what contacts press with, by the radius of gyration: hard stone and wood on themselves have about so much. */
const ARM = 0.01;

/** What is faster rolls as it does anywhere, m/s. */
const SLOW = 0.5;

/** What came out of a heap is of it until it flies or sleeps for longer, s. */
const APART = 1;

/** What a miss costs, in moments of inertia. */
const STIFFNESS = 1e3;

/** Numbers by body: impulses of the last step, and that step. */
const KEPT = 4;

/** For a snapshot. */
export interface KeptRolling {
  /** Many came out of it at once. */
  heaped: [last: number, ids: number[]][];
  /** The last step, the bodies that were held in it, and by which impulses, packed. */
  step: number;
  held: number[];
  impulses: string;
}

/**
 * What rolls, rocks or spins loses nothing by Coulomb's law, so a heap with a cylinder, a cone or a ball in it would never
 * lie still. In heaps, and there alone, what is slow is braked by a moment that is as great as its load at most; what
 * rolled out of one, too.
 */
export class RollingResistance {
  readonly #simulation: Simulation;
  readonly #contacts: ConeContacts;
  readonly #rows: BoundRows;
  readonly #bodies: TouchingBodies;
  /** Touching bodies by island. */
  #crowds = new Int32Array(16);
  /** Impulses of contacts by body, N s. */
  #loads = new Float64Array(16);
  /** The time at which bodies were of a heap last, by pointer, s. */
  readonly #heaped = new Map<number, number>();
  /** By pointer of a body. */
  readonly #kept = new Map<number, Float64Array>();

  constructor(
    simulation: Simulation,
    contacts: ConeContacts,
    rows: BoundRows,
    bodies: TouchingBodies,
  ) {
    this.#simulation = simulation;
    this.#contacts = contacts;
    this.#rows = rows;
    this.#bodies = bodies;
  }

  /** A new step: what is a heap in it, for `isHeap`. */
  begin(): void {
    const { count, pointers } = this.#bodies;
    this.#crowds.fill(0);
    if (count <= HEAP) return;
    for (let i = 0; i < count; i++) {
      const island = islandAt(this.#simulation.engine.ammo, pointers[i]!);
      if (island < 0) continue;
      if (island >= this.#crowds.length) this.#crowds = grownInt(this.#crowds, 2 * island);
      this.#crowds[island]!++;
    }
    for (let i = 0; i < count; i++)
      if (this.#isHeap(i)) this.#heaped.set(pointers[i]!, this.#simulation.time);
  }

  /** Rows for those bodies of a part that lie in a heap or came out of one. */
  add(part: Part): void {
    if (part.jointed || this.#heaped.size === 0) return;
    this.#readLoads(part);
    for (const body of part.bodies)
      if (this.#isOfHeap(body) && this.#isSlow(body)) this.#brake(body, part.rows);
  }

  isHeap({ bodies }: Part): boolean {
    return this.#isHeap(bodies[0]!);
  }

  #isHeap(body: number): boolean {
    const island = islandAt(this.#simulation.engine.ammo, this.#bodies.pointers[body]!);
    return this.#crowds[island]! > HEAP;
  }

  #isOfHeap(body: number): boolean {
    const pointer = this.#bodies.pointers[body]!;
    const { time } = this.#simulation;
    const last = this.#heaped.get(pointer);
    if (last === undefined || time - last > APART) return false;
    this.#heaped.set(pointer, time);
    return true;
  }

  #isSlow(body: number): boolean {
    const { ammo } = this.#simulation.engine;
    return speedSquared(ammo, this.#bodies.pointers[body]!) < SLOW ** 2;
  }

  #readLoads({ bodies, contacts }: Part): void {
    if (this.#loads.length < this.#bodies.count)
      this.#loads = grown(this.#loads, 2 * this.#bodies.count);
    const loads = this.#loads;
    const { values: c, a, b } = this.#contacts;
    for (const body of bodies) loads[body] = 0;
    for (const i of contacts) {
      const pressed = c[i * C.size + C.impulse]!;
      if (a[i]! >= 0) loads[a[i]!]! += pressed;
      if (b[i]! >= 0) loads[b[i]!]! += pressed;
    }
  }

  /** Three rows that keep it from turning, within what its load allows. */
  #brake(body: number, into: number[]): void {
    const { inertias, masses, pointers } = this.#bodies;
    const m = 9 * body;
    const moment = (inertias[m]! + inertias[m + 4]! + inertias[m + 8]!) / 3;
    const most = ARM * Math.sqrt(moment / masses[body]!) * this.#loads[body]!;
    if (most === 0) return;
    const kept = this.#kept.get(pointers[body]!);
    const begun = kept?.[KEPT - 1] === this.#simulation.stepsTaken - 1;
    for (let k = 0; k < 3; k++) {
      const at = this.#rows.add(body, -1);
      const r = this.#rows.values;
      r.fill(0, at, at + R.size);
      r[at + 3 + k] = 1;
      r[at + R.penalty] = STIFFNESS * moment;
      r[at + R.least] = -most;
      r[at + R.most] = most;
      r[at + R.impulse] = begun ? Math.min(most, Math.max(-most, kept![k]!)) : 0;
      into.push(this.#rows.count - 1);
    }
  }

  /** What its rows ended with, for the next step. */
  keep({ rows }: Part): void {
    const { pointers } = this.#bodies;
    const { values: r, a } = this.#rows;
    for (let j = 0; j < rows.length; j += 3) {
      const pointer = pointers[a[rows[j]!]!]!;
      let kept = this.#kept.get(pointer);
      if (!kept) this.#kept.set(pointer, (kept = new Float64Array(KEPT)));
      for (let k = 0; k < 3; k++) kept[k] = r[rows[j + k]! * R.size + R.impulse]!;
      kept[KEPT - 1] = this.#simulation.stepsTaken;
    }
  }

  /** A body that goes: another may come to stand at its pointer. */
  leave(pointer: number): void {
    this.#kept.delete(pointer);
    this.#heaped.delete(pointer);
  }

  /** By the ids of bodies, as long as anybody asks for it. */
  save(): KeptRolling {
    const { time, stepsTaken } = this.#simulation;
    const step = stepsTaken - 1;
    const heaped = new Map<number, number[]>();
    const held: number[] = [];
    const impulses: number[] = [];
    for (const { id, pointer } of this.#simulation.bodies) {
      const last = this.#heaped.get(pointer);
      if (last !== undefined && time - last <= APART) listAt(heaped, last).push(id);
      const kept = this.#kept.get(pointer);
      if (kept?.[KEPT - 1] !== step) continue;
      held.push(id);
      for (let k = 0; k < KEPT - 1; k++) impulses.push(kept[k]!);
    }
    return { heaped: [...heaped], step, held, impulses: pack(Float64Array.from(impulses)) };
  }

  load({ heaped, step, held, impulses }: KeptRolling, { body }: Numbered): void {
    this.forget();
    for (const [last, ids] of heaped)
      for (const id of ids) this.#heaped.set(body(id)?.pointer ?? 0, last);
    const all = doublesOf(impulses);
    for (let i = 0; i < held.length; i++) {
      const kept = new Float64Array(KEPT);
      kept.set(all.subarray(i * (KEPT - 1), (i + 1) * (KEPT - 1)));
      kept[KEPT - 1] = step;
      this.#kept.set(body(held[i]!)?.pointer ?? 0, kept);
    }
  }

  forget(): void {
    this.#heaped.clear();
    this.#kept.clear();
  }
}

function listAt<Key>(lists: Map<Key, number[]>, key: Key): number[] {
  const list = lists.get(key) ?? [];
  lists.set(key, list);
  return list;
}
