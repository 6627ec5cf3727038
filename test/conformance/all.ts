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
import { particleSystem } from './facts/particle-system.js';
import { pointEmitter } from './facts/point-emitter.js';
import { coneEmitter } from './facts/cone-emitter.js';
import { explosionEmitter } from './facts/explosion-emitter.js';
import { polylineEmitter } from './facts/polyline-emitter.js';
import { surfaceEmitter } from './facts/surface-emitter.js';
import { volumeEmitter } from './facts/volume-emitter.js';
import { forcePhysicsModel } from './facts/force-physics-model.js';
import { windPhysicsModel } from './facts/wind-physics-model.js';
import { boundedPhysicsModel } from './facts/bounded-physics-model.js';
import { ropes } from './facts/rope.js';
import { cloths, softBodies } from './facts/cloth.js';
import { attachments } from './facts/soft-body-attachment.js';
import { waterVolume } from './facts/water-volume.js';

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
  ParticleSystem: particleSystem,
  PointEmitter: pointEmitter,
  ConeEmitter: coneEmitter,
  ExplosionEmitter: explosionEmitter,
  PolylineEmitter: polylineEmitter,
  SurfaceEmitter: surfaceEmitter,
  VolumeEmitter: volumeEmitter,
  ForcePhysicsModel: forcePhysicsModel,
  WindPhysicsModel: windPhysicsModel,
  BoundedPhysicsModel: boundedPhysicsModel,
  Rope: ropes,
  Cloth: cloths,
  SoftBody: softBodies,
  SoftBodyAttachment: attachments,
  WaterVolume: waterVolume,
};

/** The facts of each node. */
export const factsOf: Record<string, Fact[]> = Object.fromEntries(
  Object.entries(own).map(([node, facts]) => [node, [...facts, ...commonFacts(node, facts)]]),
);
