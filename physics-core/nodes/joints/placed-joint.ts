import {
  compose,
  identityPose,
  invert,
  length,
  rotate,
  subtract,
  type Pose,
} from '../../base/math.js';
import { jointSolve } from '../../effects/joints/effects.js';
import { leverRatio, orientations, type JointFrame } from '../../effects/joints/joint-frames.js';
import type { Spring } from '../../dynamics/joint.js';
import type { JointRows } from '../../effects/joints/joint-rows.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from '../body/body.js';
import { PhysicsNode } from '../node/node.js';

/** Where a joint is at zero: its frame in each of its bodies, or the world. */
export interface JointZero {
  frame1: Pose;
  frame2: Pose;
}

/** What the rows of a joint are. */
export interface JointRowsState {
  /** Whether Bullet's A is body2. */
  swapped: boolean;
  spring?: Spring;
  /** Of each row: erp, compliance, and that in Bullet's terms. */
  corrections: [erp: number, softness: number, soft: number][];
  /** Where its stops were met last, or `UNMET`. */
  stops: number[];
}

export const UNMET = 2;

/** Where a joint is: its frame in each of its bodies, and how these stand to each other. */
export abstract class PlacedJoint extends PhysicsNode {
  body1: BodyNode | undefined;
  body2: BodyNode | undefined;
  /** The joint's frame in each body (or the world), fixed when the joint is made. */
  frame1: Pose = identityPose();
  frame2: Pose = identityPose();
  /** While a snapshot is restored: what it has of it, and of its rows, unless the level is another. */
  kept: (JointZero & { rows?: JointRowsState }) | undefined;
  #zeroed = false;

  /** Of one joint after the other. */
  protected get jointRows(): JointRows {
    return this.world.registry.get(jointSolve).rows;
  }

  /** Where the joint is wanted. */
  protected abstract wantedFrame(): JointFrame;

  // ---- its zero -----------------------------------------------------------------------------------------------------

  protected get zeroKnown(): boolean {
    return this.#zeroed;
  }

  protected forgetZero(): void {
    this.#zeroed = false;
  }

  /** If it is not known: the present poses, or those of a snapshot. */
  protected takeZero(): void {
    if (this.#zeroed) return;
    ({ frame1: this.frame1, frame2: this.frame2 } = this.kept ?? this.#framesNow());
    this.#zeroed = true;
    this.zeroed();
  }

  /** The frames are new. */
  protected zeroed(): void {}

  /** Whether its zero is known and its bodies stand somewhere: what it answers before is what its author asked for. */
  get placed(): boolean {
    return this.#zeroed && [this.body1, this.body2].every((body) => !body || body.built);
  }

  #framesNow(): { frame1: Pose; frame2: Pose } {
    const frame = this.wantedFrame();
    const { anchor } = frame;
    const [q1, q2] = orientations(frame, this.#longestArm(anchor));
    const seen = (body: BodyNode | undefined, q: Pose['q']): Pose =>
      compose(invert(body?.pose() ?? identityPose()), { p: anchor, q });
    return { frame1: seen(this.body1, q1), frame2: seen(this.body2, q2) };
  }

  #longestArm(anchor: Vec3): Vec3 {
    const body =
      (leverRatio(this.body2, anchor) > leverRatio(this.body1, anchor) ? this.body2 : this.body1) ??
      this.body2!;
    return subtract(body.centerOfMassWorld(), anchor);
  }

  // ---- where it stands now ------------------------------------------------------------------------------------------

  /** The joint's frame as each body carries it, world frame. */
  worldFrame(which: 1 | 2): Pose {
    const [body, frame] = which === 1 ? [this.body1, this.frame1] : [this.body2, this.frame2];
    return body ? compose(body.pose(), frame) : frame;
  }

  /** The same, seen from Bullet's origin. */
  frameInBullet(which: 1 | 2): Pose {
    const { p, q } = this.worldFrame(which);
    return { p: subtract(p, this.world.poses.origin), q };
  }

  anchorOn(which: 1 | 2): Vec3 {
    return this.placed ? this.worldFrame(which).p : this.asked<Vec3>('anchorPoint');
  }

  /** Distance between the two anchors, metres: 0 in a joint that holds. */
  get gap(): number {
    return this.placed ? length(subtract(this.anchorOn(1), this.anchorOn(2))) : 0;
  }

  /** ω1 - ω2, rad/s. */
  relativeSpin(): Vec3 {
    const spin = (body: BodyNode | undefined): Vec3 =>
      body ? body.motion.velocityShown().angular : [0, 0, 0];
    return subtract(spin(this.body1), spin(this.body2));
  }

  /** Column 0 to 2 (x to z) of the frame as each body carries it, world frame. */
  axisOn(which: 1 | 2, column: 0 | 1 | 2): Vec3 {
    const axis: Vec3 = [0, 0, 0];
    axis[column] = 1;
    return rotate(this.worldFrame(which).q, axis);
  }
}
