import type { Ammo } from './ammo.js';
import { SOLVER_VTABLE as VTABLE } from './offsets.js';

/** What is done in the middle of a step of Bullet. */
export interface SolverListener {
  /** Between Bullet's contact search and its solver. */
  found(): void;
  /** Between its solver and the motion of the bodies. */
  solved(): void;
}

interface FunctionTable {
  addFunction(listener: (...args: number[]) => void, signature: string): number;
}

/**
 * Bullet's solver is told before the first island is solved (`prepareSolve`) and after the last one (`allSolved`); both
 * are virtual and do nothing. A solver that is attached has a table of virtual functions of our own, in which these two
 * lead to the world that is stepping.
 */
export class SolverHook {
  readonly #ammo: Ammo;
  /** Pointer of the first function of our table. */
  #table = 0;
  #listener: SolverListener | null = null;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** `solver`: pointer of a btSequentialImpulseConstraintSolver. Only where the heap is trusted. */
  attach(solver: number): void {
    const { HEAP32 } = this.#ammo;
    this.#table ||= this.#makeTable(HEAP32[solver >> 2]!);
    HEAP32[solver >> 2] = this.#table;
  }

  /** For the step that follows. */
  listen(listener: SolverListener | null): void {
    this.#listener = listener;
  }

  /** The build has no way to give memory back: this is taken once. */
  #makeTable(theirs: number): number {
    const ammo = this.#ammo;
    const { before, after } = VTABLE;
    const memory = ammo._malloc(4 * (before + after));
    const { HEAP32 } = ammo;
    HEAP32.copyWithin(memory >> 2, (theirs >> 2) - before, (theirs >> 2) + after);
    const ours = memory + 4 * before;
    const { addFunction } = ammo as unknown as FunctionTable;
    HEAP32[(ours >> 2) + VTABLE.prepareSolve] = addFunction(() => this.#listener?.found(), 'viii');
    HEAP32[(ours >> 2) + VTABLE.allSolved] = addFunction(() => this.#listener?.solved(), 'viii');
    return ours;
  }
}
