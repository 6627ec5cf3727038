import type { Ammo } from './ammo.js';
import { SOLVER_VTABLE as VTABLE } from './offsets.js';
import { tableLike, tableOf } from './virtual-table.js';

/** What is done in the middle of a step of Bullet. */
export interface SolverListener {
  /** Between Bullet's contact search and its solver. */
  found(): void;
  /** Between its solver and the motion of the bodies. */
  solved(): void;
}

/**
 * Bullet's solver is told before the first island is solved (`prepareSolve`) and after the last one (`allSolved`); both
 * are virtual and do nothing. A solver that is attached has a table of virtual functions of our own, in which these two
 * lead to the world that is stepping.
 */
export class SolverHook {
  readonly #ammo: Ammo;
  #table = 0;
  #listener: SolverListener | null = null;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** `solver`: pointer of a btSequentialImpulseConstraintSolver. */
  attach(solver: number): void {
    this.#table ||= tableLike(this.#ammo, tableOf(this.#ammo, solver), VTABLE.count, {
      [VTABLE.prepareSolve]: { call: () => this.#listener?.found(), signature: 'viii' },
      [VTABLE.allSolved]: { call: () => this.#listener?.solved(), signature: 'viii' },
    });
    this.#ammo.HEAP32[solver >> 2] = this.#table;
  }

  /** For the step that follows. */
  listen(listener: SolverListener | null): void {
    this.#listener = listener;
  }
}
