import { offsetRows, shapeRows } from './collidables.js';
import { collectionRows, sensorRows } from './collisions.js';
import { guardRows } from './guards.js';
import { ballRows, hingeRows, motorRows } from './joints.js';
import { rows as rigidBodyRows } from './rigid-body.js';
import { rows as rigidBodyCollectionRows } from './rigid-body-collection.js';
import type { Row } from './rows.js';

/** The rows of each node type, and those that belong to no field. */
export const rowsOf: Record<string, Row[]> = {
  RigidBodyCollection: rigidBodyCollectionRows,
  RigidBody: rigidBodyRows,
  CollidableShape: shapeRows,
  CollidableOffset: offsetRows,
  CollisionCollection: collectionRows,
  CollisionSensor: sensorRows,
  BallJoint: ballRows,
  SingleAxisHingeJoint: hingeRows,
  MotorJoint: motorRows,
};

export { guardRows };
