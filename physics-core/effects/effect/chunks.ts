// Effects whose code weighs something come together with those that the same things cause.
import { Chunk } from '../../base/chunk.js';
import type { ProblemReport } from '../../base/problems.js';
import type { Quaternion } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { BulletWorld } from '../../engine/bullet-world.js';
import type { JointConstraint, Side } from '../../engine/joint-constraint.js';
import type { Vec3 } from '../../fields/types.js';

/** A world whose contacts are looked at. */
export interface PiledWorld extends Simulation {
  /** The level in force. */
  readonly accuracy: LevelName;
  settle(about: unknown, attribute?: string, code?: string): void;
}

/** What tells of what contacts do not hold. */
export interface HardContacts {
  /** After a step of `dt` seconds. */
  look(dt: number): void;
  /** Nothing is known of what was before. */
  forget(): void;
}

/** What is asked about contacts beside what effects do with them. */
export interface ContactCode {
  hardContacts(world: PiledWorld): HardContacts;
  /** Tells of bodies that the first step found inside each other. */
  reportOverlaps(simulation: Simulation): void;
  /** What a body touches now. */
  touchedBy(simulation: Simulation, body: Body): Set<Body>;
}

/** Where a joint sits, world frame, at the moment it is made. */
export interface JointFrame {
  anchor: Vec3;
  /** The frame's x, for joints about or along one axis. */
  axis?: Vec3;
  /** z of body1's frame and x of body2's, for joints about two axes; they need not be at right angles. */
  axes?: readonly [Vec3, Vec3];
}

/** The frame's axes as body1 and as body2 carry them. */
export type Orientations = [Quaternion, Quaternion];

/** A joint that says what is odd about it. */
export interface ReportedJoint extends Pick<Joint, 'body1' | 'body2' | 'label'> {
  /** Reports while it is the case, and takes it back. */
  reportWhile(is: boolean, report: ProblemReport): void;
}

/** What joints are made with. */
export interface JointCode {
  constraint(bullet: BulletWorld, side1: Side, side2: Side, swapped: boolean): JointConstraint;
  /** Of the frame, for the longest lever arm. */
  orientations(frame: JointFrame, arm: Vec3): Orientations;
  /** m r² / I: how badly a point at the end of the lever arm couples to the body's rotation. */
  leverRatio(body: Body | undefined, anchor: Vec3): number;
  reportBodies(joint: ReportedJoint): void;
  reportMassRatio(joint: ReportedJoint): void;
}

export const joints = new Chunk<JointCode>({ name: 'joints', causes: 'a joint' });

export const contacts = new Chunk<ContactCode>({
  name: 'contacts',
  causes:
    'a second RigidBody in the same world, or a fixed one, a CollisionCollection, a CollisionSensor or a Contact',
});
