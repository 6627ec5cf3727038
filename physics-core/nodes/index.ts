import { ballJoint } from './ball-joint.js';
import { collidableOffset } from './collidable-offset.js';
import { collidableShape } from './collidable-shape.js';
import { collisionCollection } from './collision-collection.js';
import { collisionSpace } from './collision-space.js';
import { collisionSensor } from './collision-sensor.js';
import { doubleAxisHingeJoint } from './double-axis-hinge-joint.js';
import { contact } from './contact.js';
import { motorJoint } from './motor-joint.js';
import { rigidBodyCollection } from './rigid-body-collection.js';
import { rigidBody } from './rigid-body.js';
import { singleAxisHingeJoint } from './single-axis-hinge-joint.js';
import { sliderJoint } from './slider-joint.js';
import { universalJoint } from './universal-joint.js';
import { byName, type NodeType } from './table.js';

/** Every node type by its X3D name. */
export const nodeTypes: Readonly<Record<string, NodeType>> = byName(
  Object.fromEntries(
    [
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
    ].map((type) => [type.name, type]),
  ),
);
