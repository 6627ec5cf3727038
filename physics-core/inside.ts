// What this repository works with: the working classes, the tables, and what reads them. People are shown index.ts.
import { measureWith } from './world/measuring.js';
import { recordings } from './world/recording.js';
import { threads } from './nodes/node/threads.js';
import { dense } from './world/snapshot/dense.js';

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
export { costs } from './effects/costs/effects.js';
export { PHASES, type Costs, type Percentiles, type Phase } from './effects/costs/phases.js';
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

recordings.comesFrom(() => import('./timeline/timeline-code.js'));
dense.comesFrom(() => import('./world/snapshot/dense/dense-code.js'));
// What comes back from another thread is dense.
threads.comesFrom(() => dense.load().then(() => import('./thread/thread-code.js')));

measureWith(async () => (await import('./accuracy/measure.js')).measureAccuracy);
