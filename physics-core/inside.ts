// What this repository works with: the working classes, the tables, and what reads them. People are shown index.ts.
import type { DebugLines } from './effects/debug/debug-lines.js';
import { loadEngine as loadBullet, type Engine } from './engine/engine.js';
import type { EngineSource, LoadOptions } from './engine/wasm.js';
import type { WorldOptions } from './world/store/types.js';
import { chunks } from './world/chunks/all.js';
import { outlines } from './effects/debug/debugging.js';
import { deformables } from './effects/deformables/effects.js';
import { ropes } from './effects/soft/effects.js';
import type { Chunk } from './base/chunk.js';
import { advice } from './nodes/node/advice.js';
import { isJoint } from './nodes/joints/is-joint.js';
import { measureWith } from './world/measuring.js';
import { recordings } from './world/recording.js';
import { threads } from './nodes/node/threads.js';
import { dense } from './world/snapshot/dense.js';
import { World } from './world/world.js';

export { loadEngine as loadBullet } from './engine/engine.js';
export { Chunk } from './base/chunk.js';
export { chunks } from './world/chunks/all.js';
export { contacts, joints } from './effects/effect/chunks.js';
export { meshes } from './shapes/meshes.js';
export { configure, type EngineSource } from './engine/wasm.js';
export type { Engine } from './engine/engine.js';
export { bulletHas, touchedBy } from './world/bullet-has.js';
export { threads } from './nodes/node/threads.js';
export { World } from './world/world.js';
export type { RayHit } from './world/rays/raycast.js';
export type { Snapshot } from './world/snapshot/snapshot.js';
export type { AddOptions, Stats, WorldOptions } from './world/store/types.js';
export { PhysicsNode } from './nodes/node/node.js';
export { nodeTypes } from './nodes/index.js';
export type { NodeDefinition as NodeType } from './nodes/node/define.js';
export { defaultOf, type Field } from './nodes/node/table.js';
export { advice, meant } from './nodes/node/advice.js';
export { cross, normalize, perpendicular, quaternionOf, quaternionOfAxes } from './base/math.js';
export { show } from './base/show.js';
export { codecs } from './fields/values.js';
export { fromSI, SI, toSI, type Units } from './fields/units.js';
export type { Access, Dimension, FieldType, Rotation, Value, Vec3 } from './fields/types.js';
export { logProblem, type Problem, type ProblemReport, type Severity } from './base/problems.js';
export { shown } from './face/shown.js';
export type { DebugLines } from './effects/debug/debug-lines.js';
export {
  monitors,
  PHASES,
  type Costs,
  type Percentiles,
  type Phase,
} from './effects/costs/frame-costs.js';
export type { FramePace } from './effects/costs/pace.js';
export type { DragMode } from './dynamics/body.js';
export type { DragEnd, Hold } from './effects/drag/hold.js';
export type { SoftSight } from './effects/drag/soft-places.js';
export { drags } from './effects/drag/effects.js';
export { debugging, outlines } from './effects/debug/debugging.js';
export { jointSolve } from './effects/joints/effects.js';
export type { EffectReport } from './effects/effect/report.js';
export type { Collision, CollisionEnd, TouchPoint } from './effects/contacts/touches.js';
export { levels, type Level, type LevelName } from './dynamics/levels.js';
export type { Run, StepHash, Timeline, TimelineMark } from './world/recording.js';
export type { LevelMeasurement, MeasureOptions } from './world/measuring.js';
export { geometryFields, type Geometry, type GeometryType } from './shapes/geometry.js';

/** Draws a started world as Bullet has it, for any renderer: `update()`, then `positions`, `colors` and `count`. */
export async function debugLines(world: World): Promise<DebugLines> {
  await outlines.load();
  return outlines.code.lines(world, {
    flush: () => world.flush(),
    joints: () => [...world.nodes].filter(isJoint),
    matter: () => [
      ...(world.registry.find(ropes)?.all ?? []),
      ...(world.registry.find(deformables)?.all ?? []),
    ],
  });
}

/** Code that pages have no words for: the entry `core` adds it. */
export const beyondPages: Chunk<unknown>[] = [];

/** The engine, and the code of all effects: nothing that is made of them waits. */
export async function loadEngine(options: LoadOptions = {}): Promise<Engine> {
  const all = [advice, recordings, dense, ...beyondPages, ...chunks].map((chunk) => chunk.load());
  const [engine] = await Promise.all([loadBullet(options), ...all]);
  return engine;
}

recordings.comesFrom(() => import('./timeline/timeline-code.js'));
dense.comesFrom(() => import('./world/snapshot/dense/dense-code.js'));
// What comes back from another thread is dense.
threads.comesFrom(() => dense.load().then(() => import('./thread/thread-code.js')));

measureWith(async () => (await import('./accuracy/measure.js')).measureAccuracy);

export interface CreateOptions extends WorldOptions, Pick<EngineSource, 'wasmUrl' | 'wasmBinary'> {
  [field: string]: unknown;
}

/**
 * A world without a page. The options are the fields of RigidBodyCollection, and `maxHeapBytes`.
 * @example
 * const world = await createWorld({ gravity: [0, -9.8, 0] });
 * const ball = world.add('RigidBody', { position: [0, 5, 0], geometry: [{ type: 'Sphere', radius: 0.5 }] });
 * world.advance(1);
 */
export async function createWorld(options: CreateOptions = {}): Promise<World> {
  const { wasmUrl, wasmBinary, console, maxHeapBytes, ...fields } = options;
  const engine = await loadEngine({ wasmUrl, wasmBinary });
  const world = new World({
    console: console ?? false,
    ...(maxHeapBytes === undefined ? {} : { maxHeapBytes }),
  });
  world.add('RigidBodyCollection', fields);
  world.start(engine);
  return world;
}
