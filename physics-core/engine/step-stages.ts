import type { Ammo } from './ammo.js';
import { SOLVER, WORLD, WORLD_VTABLE as VTABLE } from './offsets.js';
import { functionsAt, tableLike, tableOf, type WasmFunction } from './virtual-table.js';

/**
 * Bullet's step, stage by stage. Its own also asks where each body will be, to look ahead of those with a CCD threshold:
 * none here has one, since fast bodies are sent ahead by `continuous collision`. A world that is attached leaves that out,
 * a fifteenth of a step in which nothing touches (measured), and goes through the other stages as Bullet does: to the same
 * bits. Nor has any world here actions or tick callbacks.
 */
export class StepStages {
  readonly #ammo: Ammo;
  #stages: readonly WasmFunction[] = [];
  /** Tables of virtual functions. */
  #theirs = 0;
  #ours = 0;
  #listener: { islands(): void } | null = null;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** `world`: pointer of a btDiscreteDynamicsWorld. */
  attach(world: number): void {
    if (!this.#ours) this.#learn(tableOf(this.#ammo, world));
    this.#ammo.HEAP32[world >> 2] = this.#ours;
  }

  #learn(theirs: number): void {
    this.#theirs = theirs;
    this.#stages = functionsAt(this.#ammo, theirs, VTABLE.stages);
    this.#ours = tableLike(this.#ammo, theirs, VTABLE.count, {
      [VTABLE.step]: { call: this.#step, signature: 'vif' },
    });
  }

  /** From now on it steps as Bullet does. */
  detach(world: number): void {
    this.#ammo.HEAP32[world >> 2] = this.#theirs;
  }

  /** For the step that follows: told when Bullet knows its islands, before it solves them. */
  listen(listener: { islands(): void } | null): void {
    this.#listener = listener;
  }

  /** Its second stage alone. */
  collide(world: number): void {
    this.#stages[1]!(world);
  }

  readonly #step = (world: number, seconds: number): void => {
    const [predict, collide, findIslands, solve, integrate, activate] = this.#stages;
    predict!(world, seconds);
    this.#write(world + WORLD.dispatchInfo, seconds);
    collide!(world);
    findIslands!(world);
    this.#listener?.islands();
    this.#write(world + WORLD.solverInfo + SOLVER.timeStep, seconds);
    solve!(world, world + WORLD.solverInfo);
    integrate!(world, seconds);
    activate!(world, seconds);
  };

  /** The heap may have grown meanwhile. */
  #write(at: number, value: number): void {
    this.#ammo.HEAPF32[at >> 2] = value;
  }
}
