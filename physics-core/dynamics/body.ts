import type { Pose } from '../base/math.js';
import type { BtBody } from '../engine/heap.js';
import type { Rotation, Vec3 } from '../fields/types.js';
import type { CollidablePart } from './collidable.js';
import type { Joint } from './joint.js';
import type { SimulationNode } from './node.js';

/** Mass, kg, principal moments, kg m², and the frame they belong to in the body. */
export interface MassProperties {
  mass: number;
  moments: Vec3;
  centerOfMass: Pose;
}

/** Newtons and newton metres, world frame, at the centre of mass. */
export interface Load {
  force: Vec3;
  torque: Vec3;
}

/** World frame, m/s and rad/s, of the body's origin. */
export interface Velocity {
  linear: Vec3;
  angular: Vec3;
}

/** How a body comes to rest: never, unnoticed by the library, or by the X3D fields. */
export interface RestRule {
  mode: 'never' | 'library' | 'authored';
  /** Seconds, m/s, rad/s. */
  time: number;
  linearSpeed: number;
  angularSpeed: number;
}

export const DRAG_MODES = ['spring', 'kinematic', 'teleport'] as const;
export type DragMode = (typeof DRAG_MODES)[number];

/** A rigid body. Bullet's body frame is the centre of mass; X3D's is the body's origin. */
export interface Body extends SimulationNode {
  readonly body: BtBody;
  /** Of the btRigidBody on the heap. */
  readonly pointer: number;
  /** Index into poses and velocities. */
  readonly slot: number;
  /** Whether the world made it for a collidable without a body. */
  readonly isObstacle: boolean;
  /** The node that authors know it by. */
  readonly standsFor: SimulationNode;

  // ---- what it is -------------------------------------------------------------------------------------------------

  /** Whether it is simulated at all. */
  readonly active: boolean;
  /** Whether its fields let it move under forces. */
  readonly movable: boolean;
  /** Whether Bullet has it among what moves: `movable`, which asks two fields, as of the last edit. */
  readonly isDynamic: boolean;
  readonly sleeping: boolean;
  readonly joints: ReadonlySet<Joint>;
  /** What ties ropes and the like to it. */
  readonly ties: ReadonlySet<SimulationNode>;
  readonly mass: MassProperties;
  /** Centre of mass and principal axes in the body's frame. */
  readonly centerOfMass: Pose;
  /** The parts that collide, in the body's frame; and those of them that have a shape in Bullet, in Bullet's order. */
  readonly parts: readonly CollidablePart[];
  readonly solidParts: readonly CollidablePart[];
  /** The least extent of anything solid of it, metres; Infinity where it is all triangles. */
  readonly leastExtent: number;
  /** How far anything solid of it reaches from its centre of mass, metres. */
  readonly reach: number;

  // ---- what acts on it --------------------------------------------------------------------------------------------

  /** What its author's gravity gives it, and the acceleration that Bullet gives it, m/s². */
  readonly gravity: Vec3;
  readonly appliedGravity: Vec3;
  /** Of its `forces` and `torques` fields. */
  readonly constantLoad: Load;
  /** N m s; 0 where it does not damp. */
  readonly angularDamping: number;
  /** Shares of its velocities that Bullet's damping takes per second. */
  readonly dampedShare: Readonly<{ linear: number; angular: number }>;
  readonly rest: RestRule;
  readonly dragMode: DragMode;

  // ---- where it is and how it moves -------------------------------------------------------------------------------

  /** Of its origin at the last finished step. */
  pose(): Pose;
  /** The same, seen from Bullet's origin: what contacts and rays are compared with. */
  poseInBullet(): Pose;
  centerOfMassWorld(): Vec3;
  velocityAtOrigin(): Velocity;
  setVelocityAtOrigin(velocity: Velocity): void;
  /** Jumps there. */
  moveTo(pose: Pose): void;
  /** Is carried there, pushing what it meets, where it is fixed. */
  carryTo(pose: Pose): void;
  /** It stands where it does on its way, as one that is carried. */
  goAlong(): void;
  /** Carried no longer. */
  standStill(): void;
  /** Makes it immovable where it stands, or movable again. */
  hold(held: boolean): void;
  wake(): void;
  sleep(): void;
  /** A value handed to a method, or undefined after a report. */
  argument<T extends Vec3 | Rotation>(
    method: string,
    type: 'SFVec3f' | 'SFRotation',
    value: unknown,
  ): T | undefined;
}
