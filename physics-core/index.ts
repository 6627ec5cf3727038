// What the package's entry `core` gives. What the rest of this repository works with is in inside.ts.
import type { Problem } from './base/problems.js';
import type { EngineSource } from './engine/wasm.js';
import { particleSystems } from './effects/particles/effects.js';
import { deformableChunk } from './effects/deformables/effects.js';
import { ropeChunk } from './effects/soft/effects.js';
import { swimming, waters, waveChunk } from './effects/water/effects.js';
import { behind, shown } from './face/shown.js';
import type { RigidBodyCollectionFields } from './face/fields.js';
import type { World } from './face/world.js';
import * as create from './create.js';

export { configure, type EngineSource } from './engine/wasm.js';
export type * from './face/events.js';
export type * from './face/fields.js';
export type * from './face/nodes.js';
export type * from './face/values.js';
export type { NodeOptions, RayHit, SurfaceHit, World } from './face/world.js';
export type { Rotation, Vec3 } from './fields/types.js';
export type { Problem, Severity } from './base/problems.js';
export { PHASES, type Costs, type Percentiles, type Phase } from './effects/costs/phases.js';
export type { FramePace } from './effects/costs/pace.js';
export type { ColorMeaning } from './effects/debug/colors.js';
export type { DragMode } from './dynamics/body.js';
export type { DragEnd } from './effects/drag/hold.js';
export type { EffectReport } from './effects/effect/report.js';
export { levels, type Level, type LevelName } from './dynamics/levels.js';
export type { RecordOptions, Run, StepHash, Timeline, TimelineMark } from './world/recording.js';
export type { LevelMeasurement, MeasureOptions, Watching } from './world/measuring.js';
export type { Geometry } from './shapes/geometry.js';
export type { Snapshot } from './world/snapshot/snapshot.js';
export type { Stats } from './world/store/types.js';

create.beyondPages.push(
  particleSystems.comesFrom(() => import('./world/chunks/particle-code.js')),
  waters.comesFrom(() => import('./world/chunks/water-code.js')),
  ropeChunk.comesFrom(() => import('./world/chunks/rope-code.js')),
  deformableChunk.comesFrom(() => import('./world/chunks/deformable-code.js')),
  waveChunk.comesFrom(() => import('./effects/wave-code.js')),
  swimming.comesFrom(() => import('./effects/swim-code.js')),
);

/** The fields of RigidBodyCollection, and what only the world itself has. */
export interface CreateOptions
  extends RigidBodyCollectionFields, Pick<EngineSource, 'wasmUrl' | 'wasmBinary'> {
  /** Log each problem once to the console, or hand it to a function; false by default. */
  console?: boolean | ((problem: Problem) => void);
  /** Bytes that the heap of the wasm may take; 512 MB by default. */
  maxHeapBytes?: number;
}

/**
 * A world without a page, started. Rejects where the engine can't be loaded.
 * @example
 * const world = await createWorld({ gravity: [0, -9.8, 0] });
 * const ball = world.add('RigidBody', { position: [0, 5, 0], geometry: [{ type: 'Sphere', radius: 0.5 }] });
 * world.advance(1);
 */
export const createWorld = async (options: CreateOptions = {}): Promise<World> =>
  shown(await create.createWorld({ ...options }));

/** A world as coloured lines. */
export interface DebugLines {
  /** Draws all of it anew, edits that wait included. */
  update(): void;
  /** How many lines there are; the arrays may be longer. */
  readonly count: number;
  /** Both ends of each line, x y z each: world frame, metres. */
  readonly positions: Float32Array;
  /** Of each end r g b, 0 to 1. */
  readonly colors: Float32Array;
  dispose(): void;
}

/** Draws a started world as Bullet has it, for any renderer: `update()`, then `positions`, `colors` and `count`. */
export const debugLines = async (world: World): Promise<DebugLines> =>
  (await import('./debug-lines.js')).debugLines(behind(world));
