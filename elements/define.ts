import type { X3DNodeElementClass } from './node-element.js';
import { X3DBallJointElement } from './x3d-ball-joint.js';
import { X3DCollidableOffsetElement } from './x3d-collidable-offset.js';
import { X3DCollidableShapeElement } from './x3d-collidable-shape.js';
import { X3DCollisionCollectionElement } from './x3d-collision-collection.js';
import { X3DCollisionSensorElement } from './x3d-collision-sensor.js';
import { X3DMotorJointElement } from './x3d-motor-joint.js';
import { X3DRigidBodyCollectionElement } from './x3d-rigid-body-collection.js';
import { X3DRigidBodyElement } from './x3d-rigid-body.js';
import { X3DSingleAxisHingeJointElement } from './x3d-single-axis-hinge-joint.js';

export const elementClasses: readonly X3DNodeElementClass[] = [
  X3DRigidBodyCollectionElement,
  X3DRigidBodyElement,
  X3DCollidableShapeElement,
  X3DCollidableOffsetElement,
  X3DCollisionCollectionElement,
  X3DCollisionSensorElement,
  X3DBallJointElement,
  X3DSingleAxisHingeJointElement,
  X3DMotorJointElement,
];

/** Registers the tags with the page; one that another copy of the library defined stays as it is. */
export function defineElements(): void {
  for (const element of elementClasses) {
    if (!customElements.get(element.tag)) customElements.define(element.tag, element);
  }
}
