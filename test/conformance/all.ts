import type { Fact } from './fact.js';
import { ballJoint } from './facts/ball-joint.js';
import { collidableOffset } from './facts/collidable-offset.js';
import { collidableShape } from './facts/collidable-shape.js';
import { commonFacts } from './facts/common.js';
import { collisionCollection } from './facts/collision-collection.js';
import { collisionSensor } from './facts/collision-sensor.js';
import { collisionSpace } from './facts/collision-space.js';
import { contact } from './facts/contact.js';
import { doubleAxisHingeJoint } from './facts/double-axis-hinge-joint.js';
import { motorJoint } from './facts/motor-joint.js';
import { rigidBodyCollection } from './facts/rigid-body-collection.js';
import { rigidBody } from './facts/rigid-body.js';
import { singleAxisHingeJoint } from './facts/single-axis-hinge-joint.js';
import { sliderJoint } from './facts/slider-joint.js';
import { universalJoint } from './facts/universal-joint.js';

const own: Record<string, Fact[]> = {
  RigidBodyCollection: rigidBodyCollection,
  RigidBody: rigidBody,
  CollidableShape: collidableShape,
  CollidableOffset: collidableOffset,
  CollisionSpace: collisionSpace,
  CollisionCollection: collisionCollection,
  CollisionSensor: collisionSensor,
  Contact: contact,
  BallJoint: ballJoint,
  SingleAxisHingeJoint: singleAxisHingeJoint,
  DoubleAxisHingeJoint: doubleAxisHingeJoint,
  SliderJoint: sliderJoint,
  UniversalJoint: universalJoint,
  MotorJoint: motorJoint,
};

/** The facts of each node. */
export const factsOf: Record<string, Fact[]> = Object.fromEntries(
  Object.entries(own).map(([node, facts]) => [node, [...facts, ...commonFacts(node, facts)]]),
);
