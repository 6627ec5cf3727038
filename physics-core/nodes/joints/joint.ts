import { perStep, softnessAtStep } from '../../dynamics/levels.js';
import type { Vec3 } from '../../fields/types.js';
import { guards } from '../../base/guards.js';
import {
  compose,
  identityPose,
  invert,
  length,
  rotate,
  subtract,
  type Pose,
} from '../../base/math.js';
import type { Motor, RowCorrection, Spring, Stop } from '../../dynamics/joint.js';
import { areNear } from '../../effects/rest/touching.js';
import type { BodyNode } from '../body/body.js';
import type { BodyJoint } from '../body/body-joint.js';
import { JointConstraint, type Limit, type Side } from '../../engine/joint-constraint.js';
import { aboutTwoAxes, alongArm, leverRatio, type JointFrame } from './joint-frames.js';
import { reportBodies, reportMassRatio } from './joint-reports.js';
import { PhysicsNode } from '../node/node.js';

export { between, FREE, LOCKED, type Limit } from '../../engine/joint-constraint.js';
export type { JointFrame } from './joint-frames.js';

/** From 1 on Bullet lets a joint go altogether (measured: a sag of 500 m). */
const MOST_SOFTNESS = 0.9;

const ROWS = 6;

/** Lever arms that differ by less than this erp ask alike: rounding is not to decide. */
const ALIKE = 1e-3;

/** Error correction per 1/60 s, and softness (X3D's constantForceMix) where it is the joint's own. */
export type OwnCorrection = Pick<RowCorrection, 'erp'> & Partial<RowCorrection>;

/**
 * A joint as one btGeneric6DofConstraint, the one constraint of Bullet 2.82 whose every row takes an error
 * correction. Angles and separations are zero at the poses the bodies have when the joint is made.
 */
export abstract class JointNode extends PhysicsNode implements BodyJoint {
  body1: BodyNode | undefined;
  body2: BodyNode | undefined;
  /** The joint's frame in each body (or the world), fixed when the joint is made. */
  frame1: Pose = identityPose();
  frame2: Pose = identityPose();
  /** The same from each centre of mass, along its principal axes. */
  centred1: Pose = identityPose();
  centred2: Pose = identityPose();
  /** The rows that hold, as the 6-DoF numbers them: 0 to 2 along x, y, z; 3 to 5 about them. */
  lockedRows: readonly number[] = [];
  limits: readonly Limit[] = [];
  /** Per row: erp of the error repaired per step, and compliance, velocity per impulse. */
  readonly corrections: RowCorrection[] = [];
  stops: readonly Stop[] = [];
  motors: readonly Motor[] = [];
  spring: Spring | undefined;
  /** Just created: the first round of patches finds everything in place already. */
  protected fresh = false;
  /** While a snapshot is restored: the frames of its zero. */
  kept: { frame1: Pose; frame2: Pose } | undefined;
  #zeroed = false;
  #constraint: JointConstraint | undefined;

  /** Where the joint is wanted. */
  protected abstract wantedFrame(): JointFrame;
  /** Linear then angular limits along the joint frame's axes. */
  protected abstract linearLimits(): [Limit, Limit, Limit];
  protected abstract angularLimits(): [Limit, Limit, Limit];

  /** Whether its bodies may move apart along an axis. */
  protected get slides(): boolean {
    return false;
  }

  // ---- life -----------------------------------------------------------------------------------------------------

  protected override create(): boolean {
    this.#zeroed = false;
    this.fresh = true;
    this.body1 = this.asked<BodyNode | null>('body1') ?? undefined;
    this.body2 = this.asked<BodyNode | null>('body2') ?? undefined;
    for (const body of [this.body1, this.body2]) body?.joints.add(this);
    reportBodies(this);
    this.attach();
    return true;
  }

  protected override created(): void {
    this.fresh = false;
  }

  protected override destroy(): void {
    this.detach();
    this.#zeroed = false;
    for (const body of [this.body1, this.body2]) body?.joints.delete(this);
    this.body1 = this.body2 = undefined;
    this.world.registry.unmade(this);
  }

  /** Not its body's fault, if it fails. */
  bodyReady(): void {
    if (this.built) this.world.failures.attempt(this, () => this.attach());
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
    if (this.#constraint && this.shouldSwap() !== this.#constraint.swapped) this.reattach();
    else this.updateCorrection();
  }

  /** Whether its zero is known and its bodies stand somewhere: what it answers before is what its author asked for. */
  get placed(): boolean {
    return this.#zeroed && [this.body1, this.body2].every((body) => !body || body.built);
  }

  get constraint(): JointConstraint | undefined {
    return this.#constraint;
  }

  /** Bullet's rows are to hold by themselves. */
  resetTargets(): void {
    this.#constraint?.setLimits(this.limits);
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
    this.#constraint = this.#make();
    this.#setRows(this.#constraint);
    this.#constraint.add(this.slides);
    if (bodies.length === 2) this.#part(bodies[0]!, bodies[1]!);
    for (const body of bodies) body.wake();
    reportMassRatio(this);
    this.#changed();
  }

  detach(): void {
    if (!this.#constraint) return;
    this.#constraint.dispose();
    this.#constraint = undefined;
    this.wakeBodies();
    this.#changed();
  }

  /** From now on its bodies don't collide, and if they touch they let go of each other. */
  #part(a: BodyNode, b: BodyNode): void {
    if (areNear(this.world, a, b)) (a.movable ? a : b).presence.partContacts();
  }

  protected wakeBodies(): void {
    for (const body of [this.body1, this.body2]) body?.wake();
  }

  /** The constraint came or went, or its stops, motors or rows are others. */
  #changed(): void {
    this.stops = this.attached ? this.wantedStops() : [];
    this.motors = this.attached ? this.wantedMotors() : [];
    this.world.registry.jointChanged(this);
  }

  /** Stops and motors, of a joint that stands in the world. */
  protected wantedStops(): readonly Stop[] {
    return [];
  }

  protected wantedMotors(): readonly Motor[] {
    return [];
  }

  /** The one stop of a joint; where it stood stays known. */
  protected stopAt(fields: Omit<Stop, 'at'>): readonly Stop[] {
    return fields.low < fields.high ? [{ ...fields, at: this.stops[0]?.at }] : [];
  }

  get drivenBy(): string | undefined {
    return undefined;
  }

  push(_dt: number): void {}

  /** The frames are new: of the present poses, or of a snapshot's. */
  protected zeroed(): void {}

  // ---- frames -----------------------------------------------------------------------------------------------------

  #zero(): void {
    ({ frame1: this.frame1, frame2: this.frame2 } = this.kept ?? this.#framesNow());
    this.#zeroed = true;
    this.stops = [];
    this.zeroed();
  }

  #framesNow(): { frame1: Pose; frame2: Pose } {
    const { anchor, axis, axes } = this.wantedFrame();
    const [q1, q2] = axes ? aboutTwoAxes(axes) : alongArm(this.#longestArm(anchor), axis);
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

  /** Bullet's rows lie along body A's frame: A is the body whose lever arm asks for it. */
  protected shouldSwap(): boolean {
    const anchor = (body: BodyNode | undefined, frame: Pose): number =>
      body ? leverRatio(body, compose(body.pose(), frame).p) : -1;
    const first = anchor(this.body1, this.frame1);
    return anchor(this.body2, this.frame2) > first + Math.abs(first) * ALIKE;
  }

  #make(): JointConstraint {
    const side = (body: BodyNode | undefined, frame: Pose): Side =>
      body
        ? { body: body.body, frame: compose(invert(body.centerOfMass), frame) }
        : { body: this.world.bullet.ground, frame };
    const sides = [side(this.body1, this.frame1), side(this.body2, this.frame2)] as const;
    [this.centred1, this.centred2] = [sides[0].frame, sides[1].frame];
    return new JointConstraint(this.world.bullet, ...sides, this.shouldSwap());
  }

  // ---- limits and softness ------------------------------------------------------------------------------------------

  /** What its rows are is looked at before they are set. */
  protected chooseRows(): void {}

  #setRows(constraint: JointConstraint): void {
    this.chooseRows();
    this.#setLimits(constraint);
    this.#setCorrections(constraint);
  }

  #setLimits(constraint: JointConstraint): void {
    const limits = [...this.linearLimits(), ...this.angularLimits()];
    this.limits = limits;
    this.lockedRows = limits.flatMap(([low, high], row) => (low === high ? [row] : []));
    constraint.setLimits(limits);
  }

  /** Error correction and softness of every row. */
  #setCorrections(constraint: JointConstraint): void {
    const { solver, jointRows } = this.world;
    jointRows.fill(this, solver.stepSeconds);
    for (let row = 0; row < ROWS; row++) {
      const { erp, softness } = this.#correctionAt(row);
      const response = jointRows.between(row, row);
      const soft = this.#softness(softness, response);
      this.corrections[row] = { erp, softness: soft * response };
      constraint.setCorrection(row, erp, soft);
    }
  }

  /** Its limits, corrections, stops or motors are others. */
  updateRows(): void {
    if (this.fresh) return;
    if (this.#constraint) this.#setRows(this.#constraint);
    this.wakeBodies();
    this.#changed();
  }

  /** Only its motors are. */
  updateMotors(): void {
    if (this.fresh) return;
    this.wakeBodies();
    this.#changed();
  }

  /** The level or a mass changed: other rows may serve its fields now. */
  updateCorrection(): void {
    const constraint = this.#constraint;
    if (!constraint) return;
    const { spring } = this;
    this.chooseRows();
    if (!spring !== !this.spring) this.#setLimits(constraint);
    this.#setCorrections(constraint);
    this.#changed();
  }

  /** Where a row has its own; undefined: the collection's. */
  protected correctionOf(_row: number): OwnCorrection | undefined {
    return undefined;
  }

  /** Share of a row's error repaired per step, and X3D's constantForceMix for steps of this length. */
  #correctionAt(row: number): RowCorrection {
    const { errorCorrection, constantForceMix, stepSeconds } = this.world.solver;
    const own = this.correctionOf(row);
    return {
      erp: own ? perStep(own.erp, stepSeconds) : errorCorrection,
      softness:
        own?.softness === undefined
          ? constantForceMix
          : softnessAtStep(own.softness, own.erp, stepSeconds),
    };
  }

  /**
   * X3D's constantForceMix is velocity per force; Bullet 2.82 scales it by the row's own response, so it is divided by
   * dt · J M⁻¹ Jᵀ.
   */
  #softness(constantForceMix: number, response: number): number {
    const { stepSeconds } = this.world.solver;
    return guards.jointSoftness(
      constantForceMix / (stepSeconds * response || Infinity),
      MOST_SOFTNESS,
    );
  }

  // ---- outputs ------------------------------------------------------------------------------------------------------

  /** The joint's frame as each body carries it, world frame. */
  worldFrame(which: 1 | 2): Pose {
    const [body, frame] = which === 1 ? [this.body1, this.frame1] : [this.body2, this.frame2];
    return body ? compose(body.pose(), frame) : frame;
  }

  anchorOn(which: 1 | 2): Vec3 {
    return this.placed ? this.worldFrame(which).p : this.asked<Vec3>('anchorPoint');
  }

  /** Distance between the two anchors, metres: 0 in a joint that holds. */
  get gap(): number {
    return this.placed ? length(subtract(this.anchorOn(1), this.anchorOn(2))) : 0;
  }

  /** Whether forceOutput asks for an output: only then is it sent along ROUTEs. Who reads one has asked. */
  outputs(name: string): boolean {
    const wanted = this.asked<string[]>('forceOutput');
    return wanted.includes('ALL') || wanted.includes(name);
  }

  /** ω1 - ω2, rad/s. */
  relativeSpin(): Vec3 {
    const spin = (body: BodyNode | undefined): Vec3 =>
      body ? body.velocityAtOrigin().angular : [0, 0, 0];
    return subtract(spin(this.body1), spin(this.body2));
  }

  /** Column 0 to 2 (x to z) of the frame as each body carries it, world frame. */
  axisOn(which: 1 | 2, column: 0 | 1 | 2): Vec3 {
    const axis: Vec3 = [0, 0, 0];
    axis[column] = 1;
    return rotate(this.worldFrame(which).q, axis);
  }

  /** Where a row stands now, metres or radians; 0 at the poses the joint was made at. */
  valueOf(row: number): number {
    return this.placed ? this.world.jointRows.valueOf(this, row) : 0;
  }

  /** Its rate, per second. */
  rateOf(row: number): number {
    return this.placed ? this.world.jointRows.rateOf(this, row) : 0;
  }
}
