import type { Pose } from '../base/math.js';
import type { JointConstraint } from '../engine/joint-constraint.js';
import type { Limit } from '../engine/limits.js';
import type { Vec3 } from '../fields/types.js';
import type { Body } from './body.js';
import type { SimulationNode } from './node.js';

/** Of one row: share of its error repaired per step, and compliance, velocity per impulse. */
export interface RowCorrection {
  erp: number;
  softness: number;
}

/** A row of a joint that may not go past `low` and `high`; one of them may be infinite. */
export interface Stop {
  /** As the 6-DoF numbers them, body1 against body2. */
  row: number;
  low: number;
  high: number;
  /** Share of the rate that comes back. */
  bounce: number;
  /** Share of an overshoot repaired per 1/60 s. */
  correction: number;
  /** X3D's constantForceMix: how far it gives way. */
  softness: number;
  /** What `jointlimit` says of it: its field counts the other way round, and which axis it is, where there are more. */
  mirrored?: boolean;
  axis?: 1 | 2;
  /** The fields that ask for it. */
  reason: string;
  /** Where it stands: at its upper end (1), at its lower one, or between; undefined before its first step. */
  at: -1 | 0 | 1 | undefined;
}

/** A motor on one row of a joint. */
export interface Motor {
  row: number;
  /** The rate it strives for, rad/s or m/s, body1 against body2. */
  target: number;
  /** What it can muster, N m or N. */
  most: number;
}

/** A row of a joint that a spring and a damper hold at zero. */
export interface Spring {
  row: number;
  /** N/m. */
  stiffness: number;
  /** N s/m. */
  damping: number;
}

/** Two bodies, or one and the world, held by the rows of a 6-DoF: 0 to 2 along x, y, z of its frame, 3 to 5 about them. */
export interface Joint extends SimulationNode {
  readonly body1: Body | undefined;
  readonly body2: Body | undefined;
  /** Whether it stands in Bullet's world. */
  readonly attached: boolean;
  readonly constraint: JointConstraint | undefined;
  /** The rows that hold. */
  readonly lockedRows: readonly number[];
  readonly limits: readonly Limit[];
  readonly corrections: readonly RowCorrection[];
  /** The joint's frame from each centre of mass, along its principal axes. */
  readonly centred1: Pose;
  readonly centred2: Pose;
  readonly stops: readonly Stop[];
  readonly motors: readonly Motor[];
  /** Undefined also while a stiffer row of Bullet's own stands for it. */
  readonly spring: Spring | undefined;
  /** The field whose torque or force acts on its bodies in every step, whatever their rate; undefined: none does. */
  readonly drivenBy: string | undefined;
  /** That torque or force, for the next step. */
  push(dt: number): void;
  /** The joint's frame as each body carries it, world frame. */
  worldFrame(which: 1 | 2): Pose;
  /** The same, seen from Bullet's origin. */
  frameInBullet(which: 1 | 2): Pose;
  anchorOn(which: 1 | 2): Vec3;
  /** Bullet's rows are to hold by themselves. */
  resetTargets(): void;
}
