// What every entry file exports.
import { page, type Explanation } from './bridge/index.js';
import { shownInPage, type World } from './world.js';

/** The world that an element lives in: custom, plain or inlined, also before it has started. */
export const worldOf = (element: Element | null | undefined): World | undefined =>
  shownInPage(page.worldOf(element));

export { configure } from '../physics-core/inside.js';

/** What there is to know about an element; of one that is no physics node, about the body that moves it. */
export const explain = (element: Element): Explanation => page.explain(element);

export type { Explanation };
export type {
  Body,
  Costs,
  Drag,
  EffectReport,
  EngineSource,
  Level,
  LevelMeasurement,
  LevelName,
  MeasureOptions,
  Node as PhysicsNode,
  NodeOf,
  Problem,
  Snapshot,
  Stats,
  TouchPoint,
} from '../physics-core/index.js';
export type { PhysicsEventMap } from './properties.js';
export type { RayHit, World } from './world.js';
export { elementClasses } from './define.js';
export { X3DNodeElement } from './node-element.js';
export { X3DBallJointElement } from './x3d-ball-joint.js';
export { X3DCollidableOffsetElement } from './x3d-collidable-offset.js';
export { X3DCollidableShapeElement } from './x3d-collidable-shape.js';
export { X3DCollisionCollectionElement } from './x3d-collision-collection.js';
export { X3DCollisionSensorElement } from './x3d-collision-sensor.js';
export { X3DCollisionSpaceElement } from './x3d-collision-space.js';
export { X3DContactElement } from './x3d-contact.js';
export { X3DDoubleAxisHingeJointElement } from './x3d-double-axis-hinge-joint.js';
export { X3DMotorJointElement } from './x3d-motor-joint.js';
export { X3DAccuracyChartElement } from './x3d-accuracy-chart.js';
export { X3DPhysicsMonitorElement } from './x3d-physics-monitor.js';
export { X3DRigidBodyCollectionElement } from './x3d-rigid-body-collection.js';
export { X3DRigidBodyElement } from './x3d-rigid-body.js';
export { X3DSingleAxisHingeJointElement } from './x3d-single-axis-hinge-joint.js';
export { X3DSliderJointElement } from './x3d-slider-joint.js';
export { X3DUniversalJointElement } from './x3d-universal-joint.js';

// Their code comes in a chunk, once such a tag is in a page.
export type { X3DBoundedPhysicsModelElement } from './x3d-bounded-physics-model.js';
export type { X3DClothElement } from './x3d-cloth.js';
export type { X3DConeEmitterElement } from './x3d-cone-emitter.js';
export type { X3DExplosionEmitterElement } from './x3d-explosion-emitter.js';
export type { X3DForcePhysicsModelElement } from './x3d-force-physics-model.js';
export type { X3DParticleSystemElement } from './x3d-particle-system.js';
export type { X3DPointEmitterElement } from './x3d-point-emitter.js';
export type { X3DPolylineEmitterElement } from './x3d-polyline-emitter.js';
export type { X3DRopeElement } from './x3d-rope.js';
export type { X3DSoftBodyAttachmentElement } from './x3d-soft-body-attachment.js';
export type { X3DSoftBodyElement } from './x3d-soft-body.js';
export type { X3DSurfaceEmitterElement } from './x3d-surface-emitter.js';
export type { X3DVolumeEmitterElement } from './x3d-volume-emitter.js';
export type { X3DWaterVolumeElement } from './x3d-water-volume.js';
export type { X3DWindPhysicsModelElement } from './x3d-wind-physics-model.js';
