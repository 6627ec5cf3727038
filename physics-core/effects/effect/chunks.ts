// Effects whose code weighs something come together with those that the same things cause.
import { Chunk } from '../../base/chunk.js';
import type { ProblemReport } from '../../base/problems.js';
import type { Quaternion } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import type { Joint } from '../../dynamics/joint.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { BulletWorld } from '../../engine/bullet-world.js';
import type { JointConstraint, Side } from '../../engine/joint-constraint.js';
import type { Vec2, Vec3 } from '../../fields/types.js';

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

/** A node that says what contacts are like: a CollisionCollection or a Contact. */
export interface ParameterNode {
  readonly world: { readonly settings: { asked<T>(field: string): T } };
  asked<T>(field: string): T;
  authored(field: string): boolean;
}

/** What is asked about contacts beside what effects do with them. */
export interface ContactCode {
  hardContacts(world: PiledWorld): HardContacts;
  /** Tells of bodies that the first step found inside each other. */
  reportOverlaps(simulation: Simulation): void;
  /** What a body touches now. */
  touchedBy(simulation: Simulation, body: Body): Set<Body>;
  /** The parameters of a CollisionCollection or a Contact, which name one field differently. */
  contactParameters(
    node: ParameterNode,
    slipField: 'slipFactors' | 'slipCoefficients',
  ): ContactParameters;
  /** Without strict rules, friction nobody wrote is the library's default and not the field's 0. */
  frictionOf(node: ParameterNode): Vec2;
  /** Words of appliedParameters that no parameter has. */
  unknownTokens(node: ParameterNode): string[];
  /** `unknown`: words of appliedParameters that no parameter has. */
  reportTokens(
    node: Reported,
    unknown: readonly string[],
    attribute: 'appliedParameters' | 'set_contacts',
  ): void;
  /** Contacts that yield do not spring back. */
  reportSoftness(collection: Reported, softness: number): void;
  reportOneSided(collection: Reported, is: boolean): void;
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

/** A node that says what is odd about it. */
export interface Reported {
  readonly label: string;
  /** Reports while it is the case, and takes it back. */
  reportWhile(is: boolean, report: ProblemReport): void;
}

export interface ReportedJoint extends Pick<Joint, 'body1' | 'body2'>, Reported {}

/** A joint with axes that its author wrote. */
export interface AxedJoint extends Reported {
  readonly type: { readonly fields: Readonly<Record<string, { default: unknown }>> };
  asked<T>(field: string): T;
}

/** An authored axis that can't be used as it is. */
export interface OddAxis {
  attribute: string;
  used: Vec3;
  why: string;
}

export interface ReportedMotor extends AxedJoint {
  authored(field: string): boolean;
}

/** What joints are made with. */
export interface JointCode {
  constraint(bullet: BulletWorld, side1: Side, side2: Side, swapped: boolean): JointConstraint;
  /** Of the frame, for the longest lever arm. */
  orientations(frame: JointFrame, arm: Vec3): Orientations;
  /** m r² / I: how badly a point at the end of the lever arm couples to the body's rotation. */
  leverRatio(body: Body | undefined, anchor: Vec3): number;
  /** The authored axis, or X3D 4.0's default after a report where it has no direction. */
  direction(joint: AxedJoint, attribute: string): Vec3;
  /** The second axis, or one at right angles to the first after a report where both are nearly one. */
  notAlong(joint: AxedJoint, axis1: Vec3, attribute: string): Vec3;
  reportAxis(joint: AxedJoint, is: boolean, axis: OddAxis): void;
  reportBodies(joint: ReportedJoint): void;
  reportMassRatio(joint: ReportedJoint): void;
  /** What its author wrote, but what turns nothing. */
  reportIdle(motor: ReportedMotor): void;
}

export const joints = new Chunk<JointCode>({ name: 'joints', causes: 'a joint' });

export const contacts = new Chunk<ContactCode>({
  name: 'contacts',
  causes:
    'a second RigidBody in the same world, or a fixed one, a CollisionCollection, a CollisionSensor or a Contact',
});
