import { use } from '../conformance/scenes.js';
import { bodyEdits, offsetEdits, shapeEdits } from './bodies.js';
import { AXES, kept, OFF, ON, POINTS, SHARES, type Edit } from './edit.js';
import { edits as jointEdits } from './joints.js';
import { particleEdits } from './particles.js';
import { clothEdits, softBodyEdits } from './deformables.js';
import { attachmentEdits, ropeEdits } from './ropes.js';
import { waterEdits } from './water.js';
import {
  collectionEdits,
  parameterEdits,
  sensorEdits,
  SLIP,
  spaceEdits,
  worldEdits,
} from './worlds.js';

const BODIES = [use('spare'), use('pole')] as const;
const SHAPES = [use('spareShape'), use('poleShape')] as const;

/** A contact that stands alone: nothing in Bullet waits for it. */
const contactEdits: Record<string, Edit> = {
  ...Object.fromEntries(
    Object.entries(parameterEdits).map(([name, values]) => [name, kept(values)]),
  ),
  slipCoefficients: kept(SLIP),
  body1: kept(BODIES),
  body2: kept(BODIES),
  contactNormal: kept(AXES),
  depth: kept(SHARES),
  frictionDirection: kept(AXES),
  geometry1: kept(SHAPES),
  geometry2: kept(SHAPES),
  position: kept(POINTS),
};

/** Of all nodes that have them. */
const commonEdits: Record<string, Edit> = {
  metadata: kept([use('data'), use('moreData')]),
  bboxCenter: kept(POINTS),
  bboxSize: kept(POINTS),
  bboxDisplay: kept(ON),
  visible: kept(OFF),
  description: kept(['one', 'two']),
};

/** How each field of each node type is edited, and what that changes. */
const table: Record<string, Record<string, Edit>> = {
  RigidBodyCollection: worldEdits,
  RigidBody: bodyEdits,
  CollidableShape: shapeEdits,
  CollidableOffset: offsetEdits,
  CollisionCollection: collectionEdits,
  CollisionSpace: spaceEdits,
  CollisionSensor: sensorEdits,
  Contact: contactEdits,
  ...jointEdits,
  ...particleEdits,
  Cloth: clothEdits,
  SoftBody: softBodyEdits,
  Rope: ropeEdits,
  SoftBodyAttachment: attachmentEdits,
  WaterVolume: waterEdits,
};

export const editOf = (type: string, field: string): Edit | undefined =>
  table[type]?.[field] ?? commonEdits[field];
