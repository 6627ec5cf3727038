import type { LevelName } from '../dynamics/levels.js';
import type { Snapshot } from './snapshot/snapshot.js';
import type { World } from './world.js';

/** Who waits for a measurement. */
export interface Watching {
  /** The share that is done, 0 to 1. */
  onprogress?: ((done: number) => void) | undefined;
  signal?: AbortSignal | undefined;
}

export interface MeasureOptions extends Watching {
  /** Simulated seconds, 2 by default. */
  seconds?: number;
  /** All by default. */
  levels?: readonly LevelName[];
}

/** What one level costs and leaves. */
export interface Measured {
  level: LevelName;
  timeStep: number;
  /** Milliseconds of work per simulated second. */
  msPerSecond: number;
  error: {
    /** The greatest distance of a body from where the finest level has it, metres. */
    position: number;
    /** Mean difference from the energy that the finest level has, as a share of the energy in play. */
    energy: number;
    /** The widest gap of a joint after the first quarter of the run, metres. */
    joint: number;
    /** The deepest overlap after the first quarter, metres. */
    penetration: number;
  };
  /** Id of the body that is farthest off. */
  worst: number | undefined;
  /** Whether roundings grow until they decide where bodies are. */
  chaotic: boolean;
  /** Seconds up to which levels agree within `tolerance` (metres): `position` and `energy` count up to here. */
  horizon: number;
  tolerance: number;
  seconds: number;
  /** Contact points at the end. */
  contacts: number;
}

/** Something of a page that a second world can't have. */
export interface LeftOut {
  element: unknown;
  reason: string;
}

/** What one level costs and leaves in a scene, against the finest of those measured. */
export interface LevelMeasurement extends Omit<Measured, 'worst'> {
  /** The element (in the core: node) of the body that is farthest off. */
  worst: unknown;
  /** Whether it was measured in a worker; else on this thread, in slices. */
  inWorker: boolean;
  /** What acts on the scene from outside, and so not where it was measured. */
  leftOut: LeftOut[];
}

/** Runs a world's scene anew, from a snapshot of it, at each level. */
export type Measure = (
  world: World,
  snapshot: Snapshot,
  options: MeasureOptions,
) => Promise<LevelMeasurement[]>;

/** Code of its own, which worlds are not made of: the room that measures stands above them and says where it is. */
let load: (() => Promise<Measure>) | undefined;

export function measureWith(loaded: () => Promise<Measure>): void {
  load = loaded;
}

export async function measure(world: World, options: MeasureOptions): Promise<LevelMeasurement[]> {
  const { elsewhere } = world;
  const taken = elsewhere ? await elsewhere.ask('snapshot', []) : world.snapshot();
  const run = await load!();
  return run(world, taken as Snapshot, options);
}
