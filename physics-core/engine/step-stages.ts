import type { Ammo } from './ammo.js';
import { SOLVER, WORLD, WORLD_VTABLE as VTABLE } from './offsets.js';
import { functionsAt, tableLike, tableOf, type WasmFunction } from './virtual-table.js';

/** Of a step, in its order, with how many numbers each takes: the world, and seconds or the solver's settings. */
const STAGES = {
  predictUnconstraintMotion: 2,
  performDiscreteCollisionDetection: 1,
  calculateSimulationIslands: 1,
  solveConstraints: 2,
  integrateTransforms: 2,
  updateActivationState: 2,
} as const;

type Stages = Record<keyof typeof STAGES, WasmFunction>;

/** Undefined: this build has others there. */
function stagesIn(ammo: Ammo, table: number): Stages | undefined {
  const names = Object.keys(STAGES) as (keyof Stages)[];
  const functions = functionsAt(
    ammo,
    table,
    names.map((name) => VTABLE[name]),
  );
  const known = functions.every((each, i) => each?.length === STAGES[names[i]!]);
  return known
    ? (Object.fromEntries(names.map((name, i) => [name, functions[i]])) as Stages)
    : undefined;
}

/**
 * Bullet's step, stage by stage. Its own also asks where each body will be, to look ahead of those with a CCD threshold:
 * none here has one, since fast bodies are sent ahead by `continuous collision`. A world that is attached leaves that out,
 * a fifteenth of a step in which nothing touches (measured), and goes through the other stages as Bullet does: to the same
 * bits. Nor has any world here actions or tick callbacks.
 */
export class StepStages {
  readonly #ammo: Ammo;
  readonly #stages: Stages;
  /** Tables of virtual functions. */
  readonly #theirs: number;
  readonly #ours: number;

  private constructor(ammo: Ammo, theirs: number, stages: Stages) {
    this.#ammo = ammo;
    this.#stages = stages;
    this.#theirs = theirs;
    this.#ours = tableLike(ammo, theirs, VTABLE.count, {
      [VTABLE.internalSingleStepSimulation]: { call: this.#step, signature: 'vif' },
    });
  }

  /** By the pointer of a btDiscreteDynamicsWorld. Only where the heap is trusted; undefined: its functions are not known. */
  static of(ammo: Ammo, world: number): StepStages | undefined {
    const theirs = tableOf(ammo, world);
    const stages = stagesIn(ammo, theirs);
    return stages && new StepStages(ammo, theirs, stages);
  }

  attach(world: number): void {
    this.#ammo.HEAP32[world >> 2] = this.#ours;
  }

  /** From now on it steps as Bullet does. */
  detach(world: number): void {
    this.#ammo.HEAP32[world >> 2] = this.#theirs;
  }

  readonly #step = (world: number, seconds: number): void => {
    const stages = this.#stages;
    stages.predictUnconstraintMotion(world, seconds);
    this.#write(world + WORLD.dispatchInfo, seconds);
    stages.performDiscreteCollisionDetection(world);
    stages.calculateSimulationIslands(world);
    this.#write(world + WORLD.solverInfo + SOLVER.timeStep, seconds);
    stages.solveConstraints(world, world + WORLD.solverInfo);
    stages.integrateTransforms(world, seconds);
    stages.updateActivationState(world, seconds);
  };

  /** The heap may have grown meanwhile. */
  #write(at: number, value: number): void {
    this.#ammo.HEAPF32[at >> 2] = value;
  }
}
