import { offsetRows, shapeRows } from './collision/collidables.js';
import { chainRows } from './collision/chains.js';
import { collectionRows, sensorRows } from './collision/collisions.js';
import { contactRows } from './collision/contacts.js';
import { contactShapeRows } from './body/contact-shapes.js';
import { contactSolveRows } from './body/contact-solve.js';
import { bodyDragRows, collectionDragRows } from './body/dragging.js';
import { setContactsRows } from './collision/set-contacts.js';
import { commonRows } from './common.js';
import { jointSolveRows } from './joints/joint-solve.js';
import { guardRows as valueRows } from './guards.js';
import { jamRows } from './jammed.js';
import { ballRows, hingeRows } from './joints/hinge.js';
import { motorRows } from './joints/motor.js';
import { sliderRows } from './joints/slider.js';
import { doubleHingeRows, universalRows } from './joints/two-axes.js';
import { rows as rigidBodyRows } from './body/rigid-body.js';
import { rows as rigidBodyCollectionRows } from './rigid-body-collection.js';
import { particleRows, surfaceRows, systemRows, volumeRows } from './particles.js';
import { floatingRows, waterRows } from './water-volume.js';
import { clothRows, givingRows } from './cloth.js';
import { softBodyRows } from './soft-body.js';
import { attachmentRows, hangingRows, ropeRows } from './rope.js';
import type { Row } from './row.js';
import { spaceRows } from './collision/spaces.js';

const ownRows: Record<string, Row[]> = {
  RigidBodyCollection: [...rigidBodyCollectionRows, ...setContactsRows, ...collectionDragRows],
  RigidBody: [...rigidBodyRows, ...bodyDragRows, ...contactShapeRows, ...contactSolveRows],
  CollidableShape: shapeRows,
  CollidableOffset: offsetRows,
  CollisionCollection: [...collectionRows, ...chainRows],
  CollisionSpace: spaceRows,
  CollisionSensor: sensorRows,
  Contact: contactRows,
  BallJoint: [...ballRows, ...jointSolveRows],
  SingleAxisHingeJoint: hingeRows,
  DoubleAxisHingeJoint: doubleHingeRows,
  SliderJoint: sliderRows,
  UniversalJoint: universalRows,
  MotorJoint: motorRows,
  ParticleSystem: systemRows,
  PointEmitter: [],
  ConeEmitter: [],
  ExplosionEmitter: [],
  PolylineEmitter: [],
  SurfaceEmitter: surfaceRows,
  VolumeEmitter: volumeRows,
  ForcePhysicsModel: [],
  WindPhysicsModel: [],
  BoundedPhysicsModel: [],
  Rope: ropeRows,
  Cloth: clothRows,
  SoftBody: softBodyRows,
  SoftBodyAttachment: attachmentRows,
  WaterVolume: waterRows,
};

/** The rows of each node type, and those that belong to no field. */
export const rowsOf: Record<string, Row[]> = Object.fromEntries(
  Object.entries(ownRows).map(([type, rows]) => [type, [...rows, ...commonRows(type)]]),
);

export const guardRows: Row[] = [...valueRows, ...jamRows];

/** Of effects whose nodes' tables come in a chunk. */
export const lateRows: Row[] = [...particleRows, ...floatingRows, ...hangingRows, ...givingRows];
