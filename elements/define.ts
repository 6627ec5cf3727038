import { deformableTags, particleTags, ropeTags, waterTags } from './bridge/index.js';
import type { X3DNodeElementClass } from './node-element.js';
import { X3DAccuracyChartElement } from './x3d-accuracy-chart.js';
import { X3DBallJointElement } from './x3d-ball-joint.js';
import { X3DCollidableOffsetElement } from './x3d-collidable-offset.js';
import { X3DCollidableShapeElement } from './x3d-collidable-shape.js';
import { X3DCollisionCollectionElement } from './x3d-collision-collection.js';
import { X3DCollisionSensorElement } from './x3d-collision-sensor.js';
import { X3DCollisionSpaceElement } from './x3d-collision-space.js';
import { X3DContactElement } from './x3d-contact.js';
import { X3DDoubleAxisHingeJointElement } from './x3d-double-axis-hinge-joint.js';
import { X3DMotorJointElement } from './x3d-motor-joint.js';
import { X3DPhysicsMonitorElement } from './x3d-physics-monitor.js';
import { X3DRigidBodyCollectionElement } from './x3d-rigid-body-collection.js';
import { X3DRigidBodyElement } from './x3d-rigid-body.js';
import { X3DSingleAxisHingeJointElement } from './x3d-single-axis-hinge-joint.js';
import { X3DSliderJointElement } from './x3d-slider-joint.js';
import { X3DUniversalJointElement } from './x3d-universal-joint.js';

export const elementClasses: readonly X3DNodeElementClass[] = [
  X3DRigidBodyCollectionElement,
  X3DRigidBodyElement,
  X3DCollidableShapeElement,
  X3DCollidableOffsetElement,
  X3DCollisionCollectionElement,
  X3DCollisionSpaceElement,
  X3DCollisionSensorElement,
  X3DContactElement,
  X3DBallJointElement,
  X3DSingleAxisHingeJointElement,
  X3DDoubleAxisHingeJointElement,
  X3DSliderJointElement,
  X3DUniversalJointElement,
  X3DMotorJointElement,
];

/** What shows a world, and is no node of one. */
export const uiClasses = [X3DAccuracyChartElement, X3DPhysicsMonitorElement] as const;

particleTags.comesFrom(() => import('./particles.js').then((file) => file.whole()));
waterTags.comesFrom(() => import('./water.js').then((file) => file.whole()));
ropeTags.comesFrom(() => import('./ropes.js').then((file) => file.whole()));
deformableTags.comesFrom(() => import('./deformables.js').then((file) => file.whole()));

/** Registers tags with the page; one that is defined already stays as it is. */
export function defineElements(
  classes: readonly (CustomElementConstructor & { tag: string })[] = [
    ...elementClasses,
    ...uiClasses,
  ],
): void {
  for (const element of classes) {
    if (!customElements.get(element.tag)) customElements.define(element.tag, element);
  }
}
