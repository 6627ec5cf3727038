import { ballJoint } from './joints/ball-joint.js';
import { collidableOffset } from './collision/collidable-offset.js';
import { collidableShape } from './collision/collidable-shape.js';
import { collisionCollection } from './collision/collision-collection.js';
import { collisionSpace } from './collision/collision-space.js';
import { collisionSensor } from './collision/collision-sensor.js';
import { doubleAxisHingeJoint } from './joints/double-axis-hinge-joint.js';
import { contact } from './collision/contact.js';
import { motorJoint } from './joints/motor-joint.js';
import { rigidBodyCollection } from './rigid-body-collection.js';
import { rigidBody } from './body/rigid-body.js';
import { singleAxisHingeJoint } from './joints/single-axis-hinge-joint.js';
import { sliderJoint } from './joints/slider-joint.js';
import { universalJoint } from './joints/universal-joint.js';
import type { NodeDefinition } from './node/define.js';
import { byName } from './node/table.js';

const all: readonly NodeDefinition[] = [
  rigidBodyCollection,
  rigidBody,
  collidableShape,
  collidableOffset,
  collisionCollection,
  collisionSpace,
  collisionSensor,
  contact,
  ballJoint,
  singleAxisHingeJoint,
  doubleAxisHingeJoint,
  sliderJoint,
  universalJoint,
  motorJoint,
];

/** Every node type by its X3D name. */
export const nodeTypes: Readonly<Record<string, NodeDefinition>> = byName(
  Object.fromEntries(all.map((type) => [type.name, type])),
);
