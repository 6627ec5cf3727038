import type { BtConstraint } from '../engine/bullet-world.js';
import type { Ammo } from '../engine/ammo.js';
import { CONSTRAINT_PARAM } from '../engine/offsets.js';
import { Owner } from '../engine/owner.js';
import { perStep } from '../accuracy/levels.js';
import type { Vec3 } from '../fields/types.js';
import { guards } from '../guards.js';
import {
  compose,
  identityPose,
  invert,
  length,
  normalize,
  perpendicular,
  quaternionOfAxes,
  cross,
  dot,
  rotate,
  scale,
  subtract,
  type Pose,
} from '../math.js';
import type { BodyNode } from './body.js';
import { PhysicsNode } from './node.js';

type SixDof = Ammo['btGeneric6DofConstraint']['prototype'];

/** Lower and upper bound of one degree of freedom, body1 relative to body2. Lower above upper: free. */
export type Limit = readonly [number, number];

export const FREE: Limit = [1, -1];
/**
 * Not 0: Bullet's 6-DoF drops a locked row whose error is exactly the limit, so a hinge hanging straight would fall
 * for one step and be pulled back in the next, for ever (measured).
 */
export const LOCKED: Limit = [1e-20, 1e-20];

/** From 1 on Bullet lets a joint go altogether (measured: a sag of 500 m). */
const MOST_SOFTNESS = 0.9;

/** Masses more unlike than this strain a joint visibly at `standard` (measured). */
const HARD_MASS_RATIO = 100;

/** Where a joint sits, world frame, at the moment it is made. Its x axis is the one that `limits` speak of first. */
export interface JointFrame {
  anchor: Vec3;
  axis?: Vec3;
}

const flipped = ([low, high]: Limit): Limit =>
  low > high || low === high ? [low, high] : [-high, -low];

/**
 * A joint as one btGeneric6DofConstraint, the one constraint of Bullet 2.82 whose every row takes an error
 * correction. Angles and separations are zero at the poses the bodies have when the joint is made.
 */
export abstract class JointNode extends PhysicsNode {
  body1: BodyNode | undefined;
  body2: BodyNode | undefined;
  /** The joint's frame in each body (or the world), fixed when the joint is made. */
  frame1: Pose = identityPose();
  frame2: Pose = identityPose();
  #zeroed = false;
  #constraint: SixDof | undefined;
  #owner: Owner | undefined;
  /** Whether body2 is Bullet's A. */
  #swapped = false;

  /** Where the joint is wanted; undefined where it has no place. */
  protected abstract wantedFrame(): JointFrame;
  /** Linear then angular limits along the joint frame's axes. */
  protected abstract linearLimits(): [Limit, Limit, Limit];
  protected abstract angularLimits(): [Limit, Limit, Limit];

  // ---- life -----------------------------------------------------------------------------------------------------

  protected override create(): boolean {
    this.#zeroed = false;
    this.updateBodies();
    return true;
  }

  protected override destroy(): void {
    this.detach();
    this.#zeroed = false;
    for (const body of [this.body1, this.body2]) body?.joints.delete(this);
    this.body1 = this.body2 = undefined;
    this.world.registry.dropAll(this);
  }

  /** `body1` or `body2` names somebody else. */
  updateBodies(): void {
    this.detach();
    for (const body of [this.body1, this.body2]) body?.joints.delete(this);
    this.body1 = this.asked<BodyNode | null>('body1') ?? undefined;
    this.body2 = this.asked<BodyNode | null>('body2') ?? undefined;
    for (const body of [this.body1, this.body2]) body?.joints.add(this);
    this.#zeroed = false;
    this.#reportNobody();
    this.attach();
  }

  #reportNobody(): void {
    if (this.body1 || this.body2) {
      this.world.settle(this, undefined, 'no-body');
      return;
    }
    this.report({
      code: 'no-body',
      severity: 'warning',
      used: 'nothing',
      message: `${this.label} names no body and holds nothing until body1 or body2 does`,
    });
  }

  bodyReady(): void {
    if (this.built) this.attach();
  }

  bodyGone(): void {
    this.detach();
  }

  /** The same joint at the same places of the bodies: after a change of mass or centre of mass. */
  reattach(): void {
    if (!this.#constraint) return;
    this.detach();
    this.attach();
  }

  massChanged(): void {
    if (this.#constraint && this.#shouldSwap() !== this.#swapped) this.reattach();
  }

  /** Anchor or axis was edited: the joint is made again and its zero is now. */
  rezero(): void {
    if (!this.built) return;
    this.detach();
    this.#zeroed = false;
    this.attach();
  }

  get attached(): boolean {
    return this.#constraint !== undefined;
  }

  attach(): void {
    if (this.#constraint || this.removed) return;
    const bodies = [this.body1, this.body2].filter((body) => body !== undefined);
    if (bodies.length === 0 || bodies[0] === bodies[1] || bodies.some((body) => !body.active))
      return;
    if (!this.#zeroed) this.#zero();
    this.#swapped = this.#shouldSwap();
    this.#owner = new Owner(this.world.engine.ammo);
    this.#constraint = this.#owner.own(this.#make());
    this.updateLimits();
    this.updateCorrection();
    this.world.bullet.addConstraint(this.#constraint as BtConstraint);
    for (const body of bodies) body.wake();
    this.#reportMassRatio();
    this.attachedChanged();
  }

  #reportMassRatio(): void {
    const masses = [this.body1, this.body2].map((body) => (body?.movable ? body.mass.mass : 0));
    const ratio = Math.max(...masses) / Math.min(...masses);
    if (!Number.isFinite(ratio) || ratio <= HARD_MASS_RATIO) {
      this.world.settle(this, undefined, 'mass-ratio');
      return;
    }
    this.report({
      code: 'mass-ratio',
      severity: 'warning',
      value: ratio,
      used: 'the present accuracy',
      message: `${this.label} holds ${this.body1!.label} (${masses[0]} kg) to ${this.body2!.label} (${masses[1]} kg): so unlike masses need accuracy="fine" or better to hold together`,
    });
  }

  detach(): void {
    if (!this.#constraint) return;
    this.world.bullet.removeConstraint(this.#constraint as BtConstraint);
    this.#owner!.dispose();
    this.#constraint = undefined;
    for (const body of [this.body1, this.body2]) body?.wake();
    this.attachedChanged();
  }

  /** The constraint came or went. */
  protected attachedChanged(): void {}

  // ---- frames -----------------------------------------------------------------------------------------------------

  #zero(): void {
    const { anchor, axis } = this.wantedFrame();
    const frame: Pose = { p: anchor, q: this.#orientation(anchor, axis) };
    this.frame1 = compose(invert(this.body1?.pose() ?? identityPose()), frame);
    this.frame2 = compose(invert(this.body2?.pose() ?? identityPose()), frame);
    this.#zeroed = true;
  }

  /**
   * Rows along the lever arm: world axes would couple the rows through a small inertia, and the solver would let the
   * joint open (measured). Without an axis of its own the frame's x runs along the arm; else its z does.
   */
  #orientation(anchor: Vec3, axis: Vec3 | undefined) {
    const arm = this.#longestArm(anchor);
    if (!axis) {
      const x = normalize(arm, [1, 0, 0]);
      const y = perpendicular(x);
      return quaternionOfAxes(x, y, cross(x, y));
    }
    const x = normalize(axis);
    const across = subtract(arm, scale(x, dot(arm, x)));
    const z = length(across) > 1e-6 ? normalize(across) : perpendicular(x);
    return quaternionOfAxes(x, cross(z, x), z);
  }

  #longestArm(anchor: Vec3): Vec3 {
    const body =
      (leverRatio(this.body2, anchor) > leverRatio(this.body1, anchor) ? this.body2 : this.body1) ??
      this.body2!;
    return subtract(body.centerOfMassWorld(), anchor);
  }

  /** Bullet's rows lie along body A's frame: A is the body whose lever arm asks for it. */
  #shouldSwap(): boolean {
    const anchor = (body: BodyNode | undefined, frame: Pose): number =>
      body ? leverRatio(body, compose(body.pose(), frame).p) : -1;
    return anchor(this.body2, this.frame2) > anchor(this.body1, this.frame1);
  }

  #make(): SixDof {
    const { engine } = this.world;
    const ends = [
      { body: this.body1, frame: this.frame1 },
      { body: this.body2, frame: this.frame2 },
    ];
    const [a, b] = (this.#swapped ? ends.reverse() : ends) as [(typeof ends)[0], (typeof ends)[0]];
    const inCentre = ({ body, frame }: (typeof ends)[0]): Pose =>
      body ? compose(invert(body.centerOfMass), frame) : frame;
    const [frameA, frameB] = [inCentre(a), inCentre(b)];
    const bullet = (body: BodyNode | undefined) => body?.body ?? this.world.bullet.ground;
    return new engine.ammo.btGeneric6DofConstraint(
      bullet(a.body),
      bullet(b.body),
      engine.scratch.transform(frameA.p, frameA.q, 0),
      engine.scratch.transform(frameB.p, frameB.q, 1),
      true,
    );
  }

  // ---- limits and softness ------------------------------------------------------------------------------------------

  updateLimits(): void {
    const constraint = this.#constraint;
    if (!constraint) return;
    const { scratch } = this.world.engine;
    const along = (limits: Limit[], end: 0 | 1) => {
      const [x, y, z] = limits.map((limit) => (this.#swapped ? flipped(limit) : limit)[end]);
      return scratch.vector(x!, y!, z!);
    };
    const linear = this.linearLimits();
    const angular = this.angularLimits();
    constraint.setLinearLowerLimit(along(linear, 0));
    constraint.setLinearUpperLimit(along(linear, 1));
    constraint.setAngularLowerLimit(along(angular, 0));
    constraint.setAngularUpperLimit(along(angular, 1));
    for (const body of [this.body1, this.body2]) body?.wake();
  }

  /** Error correction of stops, per 1/60 s, where the joint has any. */
  protected stopCorrection(): number | undefined {
    return undefined;
  }

  /** Error correction and softness of every row, from the collection or the level. */
  updateCorrection(): void {
    const constraint = this.#constraint;
    if (!constraint) return;
    const { errorCorrection, constantForceMix, stepSeconds } = this.world.solver;
    const stop = this.stopCorrection();
    const limits = [...this.linearLimits(), ...this.angularLimits()];
    limits.forEach((limit, axis) => {
      const isStop = limit[0] < limit[1];
      const erp = isStop && stop !== undefined ? perStep(stop, stepSeconds) : errorCorrection;
      constraint.setParam(CONSTRAINT_PARAM.stopErp, erp, axis);
      constraint.setParam(
        CONSTRAINT_PARAM.stopCfm,
        this.#softness(constantForceMix, stepSeconds),
        axis,
      );
    });
  }

  /**
   * X3D's constantForceMix is velocity per force; Bullet 2.82 scales it by the row's own response, so it is divided by
   * dt · (1/m1 + 1/m2).
   */
  #softness(constantForceMix: number, dt: number): number {
    const inverse = (body: BodyNode | undefined): number =>
      body?.movable ? 1 / body.mass.mass : 0;
    const response = inverse(this.body1) + inverse(this.body2);
    return guards.jointSoftness(constantForceMix / (dt * response || Infinity), MOST_SOFTNESS);
  }

  // ---- outputs ------------------------------------------------------------------------------------------------------

  /** The joint's frame as each body carries it, world frame. */
  worldFrame(which: 1 | 2): Pose {
    const [body, frame] = which === 1 ? [this.body1, this.frame1] : [this.body2, this.frame2];
    return body ? compose(body.pose(), frame) : frame;
  }

  anchorOn(which: 1 | 2): Vec3 {
    return this.#zeroed ? this.worldFrame(which).p : this.asked<Vec3>('anchorPoint');
  }

  /** Distance between the two anchors, metres: 0 in a joint that holds. */
  get gap(): number {
    return length(subtract(this.anchorOn(1), this.anchorOn(2)));
  }

  /** Whether forceOutput asks for an output. */
  outputs(name: string): boolean {
    const wanted = this.asked<string[]>('forceOutput');
    return wanted.includes('ALL') || wanted.includes(name);
  }

  angularVelocityOf(body: BodyNode | undefined): Vec3 {
    return body ? body.velocityAtOrigin().angular : [0, 0, 0];
  }

  axisWorld(): Vec3 {
    return rotate(this.worldFrame(1).q, [1, 0, 0]);
  }
}

/** m r² / I: how badly a point at the end of the lever arm couples to the body's rotation. */
function leverRatio(body: BodyNode | undefined, anchor: Vec3): number {
  if (!body?.movable) return -1;
  const arm = length(subtract(body.centerOfMassWorld(), anchor));
  return (body.mass.mass * arm * arm) / Math.min(...body.mass.moments);
}
